// SPDX-License-Identifier: MIT
// The scene language as a part of a page: all of it in Markdown, in short in roff.
#pragma once

#include <string>

namespace hackle {

// Sections of the second level and below: functions, types with their methods and fields, units,
// materials. Throws Error (files) when the library of materials cannot be read.
std::string markdown_reference();

// Sections of a man page: what each function does and how it is called, fields, units.
std::string roff_reference();

}  // namespace hackle
