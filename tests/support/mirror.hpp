// SPDX-License-Identifier: MIT
// Checks whether a state is its own mirror image, to the last bit.
#pragma once

#include <gtest/gtest.h>

#include "solver/simulation.hpp"

namespace hackle::test {

// Counts nodes whose displacement, velocity or number of bonds differs from that of the mirror
// image about the horizontal midline (y -> -y), or about the vertical one.
inline int asymmetric_nodes(const Simulation& simulation, bool about_horizontal) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  const State& state = simulation.state();
  const auto degree = degrees(grid, lattice.family, state.bonds);
  const Vec2 sign = about_horizontal ? Vec2(1.0, -1.0) : Vec2(-1.0, 1.0);
  int count = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int mi = about_horizontal ? i : grid.nx - 1 - i;
      const int mj = about_horizontal ? grid.ny - 1 - j : j;
      const bool same = state.u(i, j) == Vec2(sign.cwiseProduct(state.u(mi, mj))) &&
                        state.v(i, j) == Vec2(sign.cwiseProduct(state.v(mi, mj))) &&
                        degree[grid.index(i, j)] == degree[grid.index(mi, mj)];
      count += same ? 0 : 1;
    }
  return count;
}

}  // namespace hackle::test
