// SPDX-License-Identifier: MIT
// The scene language as part of a page: complete in Markdown, short in roff.
#pragma once

#include <string>

namespace hackle {

// Returns sections of the second level and below: functions, types with their methods and fields,
// units, materials. Throws Error (files) if the library of materials cannot be read.
std::string markdown_reference();

// Returns sections of a man page: purpose and signature of each function, fields, units.
std::string roff_reference();

}  // namespace hackle
