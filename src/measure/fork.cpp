// SPDX-License-Identifier: MIT
#include "measure/fork.hpp"

#include <algorithm>

namespace hackle {

int bands(const Field& damage, const Grid& grid, int column) {
  int count = 0;
  bool inside = false;
  for (int j = 0; j < grid.ny; ++j) {
    const bool on = damage.values[grid.index(column, j)] > on_crack;
    count += on && !inside ? 1 : 0;
    inside = on;
  }
  return count;
}

int most_bands(const Field& damage, const Grid& grid) {
  int most = 0;
  for (int i = 0; i < grid.nx; ++i) most = std::max(most, bands(damage, grid, i));
  return most;
}

std::optional<double> fork_place(const Field& damage, const Grid& grid) {
  for (int i = 0; i < grid.nx; ++i)
    if (bands(damage, grid, i) >= 2) return grid.position(i, 0).x();
  return std::nullopt;
}

double tip_place(const Field& damage, const Grid& grid) {
  double farthest = 0.0;
  for (int i = 0; i < grid.nx; ++i)
    if (bands(damage, grid, i) > 0) farthest = grid.position(i, 0).x();
  return farthest;
}

}  // namespace hackle
