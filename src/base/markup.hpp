// SPDX-License-Identifier: MIT
// Plain text as it must be written in Markdown and in roff, the language of man pages.
#pragma once

#include <string>
#include <string_view>

namespace hackle {

// In prose and in cells of tables: nothing of it is taken for markup.
std::string markdown(std::string_view text);
// `text`, or "" for nothing.
std::string markdown_code(std::string_view text);

// In prose.
std::string roff(std::string_view text);
// What is typed: its hyphens stay hyphens. In bold.
std::string roff_code(std::string_view text);
// Lines as they are, indented.
std::string roff_example(std::string_view lines);

}  // namespace hackle
