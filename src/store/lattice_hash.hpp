// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lattice/lattice.hpp"

namespace hackle {

// Sixteen hexadecimal digits over what the fields of a state depend on: grid, bonds at the start,
// materials, strength. Equal only when every bit is.
std::string lattice_hash(const Lattice& lattice);

}  // namespace hackle
