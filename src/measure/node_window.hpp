// SPDX-License-Identifier: MIT
// The nodes around a place, for what looks at a part of a plate only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lattice/grid.hpp"

namespace hackle {

// Columns left..right and rows bottom..top of a grid, numbered row by row from the lower left.
struct NodeWindow {
  int left = 0, right = -1, bottom = 0, top = -1;

  std::size_t nodes() const {
    const int columns = right - left + 1, rows = top - bottom + 1;
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  bool contains(int i, int j) const { return i >= left && i <= right && j >= bottom && j <= top; }
  std::size_t index(int i, int j) const {
    const int columns = right - left + 1, row = j - bottom, column = i - left;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int j = bottom; j <= top; ++j)
      for (int i = left; i <= right; ++i) visit(i, j);
  }
};

// Returns the nodes of a square of half side `reach`, m, around a place that lies on the plate.
inline NodeWindow window_around(const Grid& grid, const Vec2& place, double reach) {
  const Vec2 middle = grid.from_centre(place) + 0.5 * Vec2(grid.nx - 1, grid.ny - 1);
  const double half = std::min(reach / grid.dx, 1.0 * (grid.nx + grid.ny));
  const auto first = [&](double x, int count) {
    return std::clamp(static_cast<int>(std::floor(x - half)), 0, count - 1);
  };
  const auto last = [&](double x, int count) {
    return std::clamp(static_cast<int>(std::ceil(x + half)), 0, count - 1);
  };
  return {first(middle.x(), grid.nx), last(middle.x(), grid.nx), first(middle.y(), grid.ny),
          last(middle.y(), grid.ny)};
}

}  // namespace hackle
