// SPDX-License-Identifier: MIT
// A node that lacks a bond, and so may touch another one.
#pragma once

#include <cstddef>

#include "solver/order_free_sum.hpp"

namespace hackle {

struct OpenNode {
  int i = 0;
  int j = 0;
  std::size_t index = 0;  // Grid::index
  Vec2 home{0, 0};        // where it was when those near it were found, in dx from the centre
  Vec2 u{0, 0};           // now, dx
  OrderFreeSum force;     // of all that touch it, in units of rho dx^3/dt^2
};

}  // namespace hackle
