// SPDX-License-Identifier: MIT
// What a user should know of the shapes of a plate on a lattice.
#pragma once

#include <string>
#include <vector>

#include "lattice/lattice.hpp"

namespace hackle {

// Cut-outs that take nothing away or only cut bonds, inclusions that cover no node, nodes that
// were left without a bond. One sentence each.
std::vector<std::string> shape_remarks(const Plate& plate, const Lattice& lattice);

}  // namespace hackle
