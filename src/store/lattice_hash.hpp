// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lattice/lattice.hpp"

namespace hackle {

// Returns sixteen hexadecimal digits over everything that the fields of a state depend on: grid,
// initial bonds, materials, strength. Equal only if every bit is.
std::string lattice_hash(const Lattice& lattice);

}  // namespace hackle
