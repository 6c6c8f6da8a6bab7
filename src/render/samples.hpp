// SPDX-License-Identifier: MIT
// Values of cells as a picture of fewer points shows them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "measure/scalar.hpp"
#include "render/layout.hpp"

namespace hackle {

// The columns or rows [first, last] of `cells` that lie at least partly under point k of `points`,
// those beyond the ends included. Decided in integers, so that mirror images see mirror images.
struct Under {
  int first = 0, last = 0;
};
Under under(int k, int points, int cells);

// One value for each of `width` x `height` points spread evenly over the window, rows from the
// bottom, from one value for each node by Grid::index. A point shows what `sampling` says of the
// nodes under it; taking one of them would drop a crack one cell wide, and the mean would fade it.
// nan, and what lies beyond the lattice, is left out; a point with nothing under it is nan.
std::vector<float> samples(std::span<const float> values, const Grid& grid, const Window& window,
                           int width, int height, Sampling sampling);

// The largest of the values under each point, 0 with nothing under it.
std::vector<std::uint8_t> samples(std::span<const std::uint8_t> values, const Grid& grid,
                                  const Window& window, int width, int height);

}  // namespace hackle
