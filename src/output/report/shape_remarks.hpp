// SPDX-License-Identifier: MIT
// Remarks on the shapes of a plate on a lattice.
#pragma once

#include <string>
#include <vector>

#include "lattice/lattice.hpp"

namespace hackle {

// Returns a sentence for each cut-out that removes nothing or only cuts bonds, each inclusion that
// covers no node, and nodes left without a bond.
std::vector<std::string> shape_remarks(const Plate& plate, const Lattice& lattice);

}  // namespace hackle
