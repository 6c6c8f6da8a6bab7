// SPDX-License-Identifier: MIT
// A node that lacks a bond, and so may touch another node.
#pragma once

#include <cstddef>

#include "solver/order_free_sum.hpp"

namespace hackle {

struct OpenNode {
  int i = 0;
  int j = 0;
  std::size_t index = 0;  // Grid::index
  Vec2 home{0, 0};        // its position when its neighbours were found, in dx from the centre
  Vec2 u{0, 0};           // now, dx
  OrderFreeSum force;     // of all contacts, in units of rho dx^3/dt^2
  double inertia = 1.0;   // density over Lattice::rho
  Vec2 v{0, 0};           // half a step ago, dx per step; only where contacts are rough
  OrderFreeSum loss;      // of friction and of what rebounds lose, as `force`
};

}  // namespace hackle
