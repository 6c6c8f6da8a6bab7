// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace hackle {

// Returns the number of columns of the terminal that a descriptor (0 to 2) leads to; 80 where it
// leads to none or the terminal does not know.
std::size_t terminal_columns(int descriptor);

// Prints "note: ..." to stderr, within the columns of a terminal.
void say_note(std::string_view text);

}  // namespace hackle
