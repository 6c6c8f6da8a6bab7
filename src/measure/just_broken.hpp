// SPDX-License-Identifier: MIT
// The bonds that broke in the last step of a simulation, by the nodes they joined.
#pragma once

#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

// A bond from node (i, j), which kept it, to (i + a, j + b).
struct LostBond {
  int i = 0, j = 0;
  int a = 0, b = 0;
  double length = 0.0;  // dx
  double weight = 0.0;  // from its quadrature
};

// Returns each of them once, in a fixed order; costs in proportion to their number.
std::vector<LostBond> just_broken(const Simulation& simulation);

}  // namespace hackle
