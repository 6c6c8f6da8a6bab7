// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "lattice/load_map.hpp"

namespace hackle {

// Where a held node goes in a step.
struct PrescribedNode {
  int i = 0;
  int j = 0;
  Vec2 move{0, 0};  // change of u in the step, lattice units
  bool along_x = true;
  bool along_y = true;
  double inertia = 1.0;  // its density over Lattice::rho
};

// What acts on the nodes in a step, besides their bonds: each node once, ordered by index.
struct Actions {
  std::vector<LoadedNode> forces;
  std::vector<PrescribedNode> prescribed;
};

}  // namespace hackle
