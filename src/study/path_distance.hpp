// SPDX-License-Identifier: MIT
// How far two sets of lines are apart.
#pragma once

#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

// Returns the distance of a point from the line between two others, m.
double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b);

// Returns the Hausdorff distance, m: no point of either set is farther than this from the other
// set. Both hold at least one point. Costs the product of their numbers of points.
double hausdorff_distance(const std::vector<std::vector<Vec2>>& one,
                          const std::vector<std::vector<Vec2>>& other);

}  // namespace hackle
