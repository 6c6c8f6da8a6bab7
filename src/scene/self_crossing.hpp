// SPDX-License-Identifier: MIT
// Whether the rim of a polygon crosses itself, as it does when its points are in no order.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "scene/shapes/polygon.hpp"

namespace hackle {

// Returns two sides that cross between their ends, by the indices of the points they begin at, the
// smaller one first; nothing if sides only touch or coincide.
std::optional<std::pair<std::size_t, std::size_t>> crossing_sides(const Polygon& polygon);

}  // namespace hackle
