// SPDX-License-Identifier: MIT
// Measures the difference between two solutions on one lattice.
#pragma once

#include <cmath>

#include "solver/simulation.hpp"

namespace hackle::test {

// Returns the L2 norm of the difference of the displacements over that of `exact`.
inline double relative_difference(const Simulation& exact, const Simulation& other) {
  const Grid& grid = exact.lattice().grid;
  double difference = 0.0, size = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (exact.lattice().is_void(i, j)) continue;
      const Vec2 u = exact.displacement(i, j);
      difference += (other.displacement(i, j) - u).squaredNorm();
      size += u.squaredNorm();
    }
  return size > 0.0 ? std::sqrt(difference / size) : std::sqrt(difference);
}

}  // namespace hackle::test
