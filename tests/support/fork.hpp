// SPDX-License-Identifier: MIT
// Where and when a crack that runs along x forks.
#pragma once

#include <optional>

#include "measure/field.hpp"

namespace hackle::test {

// Damage above which a node lies on a crack: a straight crack has 0.4 to 0.5 on its sides.
inline constexpr float on_crack = 0.35F;

// Separate runs of nodes on a crack in one column of nodes.
inline int bands(const Field& damage, const Grid& grid, int column) {
  int count = 0;
  bool inside = false;
  for (int j = 0; j < grid.ny; ++j) {
    const bool on = damage.values[grid.index(column, j)] > on_crack;
    count += on && !inside ? 1 : 0;
    inside = on;
  }
  return count;
}

// The most bands in any column.
inline int most_bands(const Field& damage, const Grid& grid) {
  int most = 0;
  for (int i = 0; i < grid.nx; ++i) most = std::max(most, bands(damage, grid, i));
  return most;
}

// The place, in m, of the first column from the left with two bands or more.
inline std::optional<double> fork_place(const Field& damage, const Grid& grid) {
  for (int i = 0; i < grid.nx; ++i)
    if (bands(damage, grid, i) >= 2) return grid.position(i, 0).x();
  return std::nullopt;
}

// The farthest place on a crack, in m.
inline double tip_place(const Field& damage, const Grid& grid) {
  double farthest = 0.0;
  for (int i = 0; i < grid.nx; ++i)
    if (bands(damage, grid, i) > 0) farthest = grid.position(i, 0).x();
  return farthest;
}

}  // namespace hackle::test
