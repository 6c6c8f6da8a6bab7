// SPDX-License-Identifier: MIT
// Where two views of one grid differ, and by how much.
#pragma once

#include <string>
#include <vector>

#include "solver/view.hpp"

namespace hackle {

struct FieldDifference {
  std::string name;  // "displacement"
  std::string unit;  // SI; "" for a pure number
  double max = 0.0;  // of a node; of a vector, the length of the difference
  int i = 0, j = 0;  // that node
  double l2 = 0.0;   // root of the mean square over all nodes

  bool is_none() const { return max == 0.0; }
};

// Displacement, velocity, damage, bonds (how many of those that a node keeps hold in one view
// only), where something is heated temperature, and where there are rigid bodies how far apart
// their places are, which counts as of one node (-1, -1). In single precision values that round to
// the same float are equal. Both views need the same grid.
enum class Compared { in_double, in_single };
std::vector<FieldDifference> differences(const View& one, const View& other, Compared how);

}  // namespace hackle
