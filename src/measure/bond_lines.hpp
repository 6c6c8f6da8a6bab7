// SPDX-License-Identifier: MIT
// The bonds of a part of the plate one by one, for drawing the lattice.
#pragma once

#include <vector>

#include "solver/view.hpp"

namespace hackle {

// A bond from node (i, j) to (i + column, j + row).
struct BondLine {
  int i = 0, j = 0;
  int column = 0, row = 0;
  bool holds = true;
};

// Columns and rows of nodes, from the first to the last.
struct NodeBlock {
  int left = 0, right = 0;
  int bottom = 0, top = 0;
};

// Returns every initial bond that a node of the block keeps; broken bonds last.
std::vector<BondLine> bond_lines(const View& view, const NodeBlock& block);

}  // namespace hackle
