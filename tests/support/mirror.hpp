// SPDX-License-Identifier: MIT
// Is a state its own mirror image, to the last bit?
#pragma once

#include <gtest/gtest.h>

#include "solver/simulation.hpp"

namespace hackle::test {

// Nodes whose displacement, velocity or number of bonds differs from the mirror image's about the
// horizontal midline (y -> -y), or about the vertical one.
inline int asymmetric_nodes(const Simulation& simulation, bool about_horizontal) {
  const Grid& grid = simulation.lattice().grid;
  const State& state = simulation.state();
  const double sx = about_horizontal ? 1.0 : -1.0, sy = -sx;
  int count = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int mi = about_horizontal ? i : grid.nx - 1 - i;
      const int mj = about_horizontal ? grid.ny - 1 - j : j;
      const auto here = static_cast<std::size_t>(state.layout.at(i, j));
      const auto there = static_cast<std::size_t>(state.layout.at(mi, mj));
      const std::size_t node = grid.index(i, j), image = grid.index(mi, mj);
      const bool same =
          state.ux[here] == sx * state.ux[there] && state.uy[here] == sy * state.uy[there] &&
          state.vx[node] == sx * state.vx[image] && state.vy[node] == sy * state.vy[image] &&
          state.bonds.count(node) == state.bonds.count(image);
      count += same ? 0 : 1;
    }
  return count;
}

// Directed bonds whose two ends disagree about whether they hold.
inline int one_sided_bonds(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const BondBits& bonds = simulation.state().bonds;
  int count = 0;
  for (const Images& image : lattice.family.images())
    for (int k = 0; k < image.count(); ++k)
      for (int j = 0; j < lattice.grid.ny; ++j)
        for (int i = 0; i < lattice.grid.nx; ++i) {
          const int a = image.column(k), b = image.row(k);
          const bool held = bonds.holds(lattice.grid.index(i, j), image.first_bit + k);
          if (!lattice.grid.contains(i + a, j + b)) {
            count += held ? 1 : 0;
            continue;
          }
          const int opposite =
              image.count() - 1 - k;  // images are listed so that -offset is last - k
          const bool back =
              bonds.holds(lattice.grid.index(i + a, j + b), image.first_bit + opposite);
          count += held == back ? 0 : 1;
        }
  return count;
}

}  // namespace hackle::test
