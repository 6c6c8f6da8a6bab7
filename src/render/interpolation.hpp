// SPDX-License-Identifier: MIT
// Values between the nodes of a lattice that is coarser than its picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/overlay/layout.hpp"

namespace hackle {

// Returns values for `width` x `height` points spread evenly over the window, at least as many as
// its cells, rows from the bottom: linear in x and y between the four nodes around a point, of
// which only those count that `links` (of Link, by Grid::index) join to the nearest one. So a crack
// is where it was: along the sides of cells. nan where the nearest node has none or is none.
std::vector<float> interpolated(std::span<const float> values, std::span<const std::uint8_t> links,
                                const Grid& grid, const Window& window, int width, int height);

}  // namespace hackle
