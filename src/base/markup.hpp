// SPDX-License-Identifier: MIT
// Escapes plain text for Markdown, for XML, and for roff, the language of man pages.
#pragma once

#include <string>
#include <string_view>

namespace hackle {

// For prose and table cells: no character is taken for markup.
std::string markdown(std::string_view text);
// Returns `text` in backquotes, or "" for an empty text.
std::string markdown_code(std::string_view text);

// For content and for attributes in double quotes.
std::string xml(std::string_view text);
// The inverse of xml().
std::string from_xml(std::string_view text);

// For prose.
std::string roff(std::string_view text);
// For text that is typed: in bold, and hyphens stay hyphens.
std::string roff_code(std::string_view text);
// For whole lines: unchanged, indented.
std::string roff_example(std::string_view lines);

}  // namespace hackle
