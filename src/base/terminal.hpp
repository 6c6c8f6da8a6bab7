// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hackle {

// Returns the number of columns of the terminal that a descriptor (0 to 2) leads to; 80 where it
// leads to none or the terminal does not know.
std::size_t terminal_columns(int descriptor);

}  // namespace hackle
