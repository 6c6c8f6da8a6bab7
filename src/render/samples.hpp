// SPDX-License-Identifier: MIT
// Reduces the values of cells to the points of a picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "measure/scalar.hpp"
#include "render/overlay/layout.hpp"

namespace hackle {

// Columns or rows [first, last] of `cells` that lie at least partly under point k of `points`,
// including those beyond the ends. Decided in integers, so that mirror images give mirror images.
struct Under {
  int first = 0, last = 0;
};
Under under(int k, int points, int cells);

// Returns values for `width` x `height` points spread evenly over the window, rows from the bottom,
// from one value per node by Grid::index. `sampling` reduces the nodes under a point to its value;
// picking one node would lose a crack one cell wide, and the mean would fade it. nan, and cells
// beyond the lattice, are ignored; a point with no value under it is nan.
std::vector<float> samples(std::span<const float> values, const Grid& grid, const Window& window,
                           int width, int height, Sampling sampling);

// Returns the largest value under each point, or 0 if there is none.
std::vector<std::uint8_t> samples(std::span<const std::uint8_t> values, const Grid& grid,
                                  const Window& window, int width, int height);

}  // namespace hackle
