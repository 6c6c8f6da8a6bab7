// SPDX-License-Identifier: MIT
// The middle of a crack below the spacing: paths between nodes are moved to where damage is the
// same on both sides.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "measure/crack_growth.hpp"

namespace hackle {

// Points in dx from the centre of the lattice.
using Points = std::vector<Vec2>;

// Moves each point of a path across it to the centroid of the damage above 0.2 within half a
// horizon, and smooths. Where two cracks are closer than 1.5 horizons they attract each other's.
Points ridge_line(const CrackGrowth& growth, const Points& path);

// Returns where the damage on the middle line that runs out of a place in a direction falls below
// 0.25, its value at the tip of a crack that cuts all bonds it crosses and no others. A rim of the
// plate that comes first, within `max` dx, is the end.
struct LineEnd {
  Vec2 place{0, 0};
  bool at_rim = false;
};
LineEnd end_of_line(const CrackGrowth& growth, const Vec2& from, const Vec2& direction, double max);

struct FittedLine {
  Vec2 point{0, 0};
  Vec2 direction{0, 0};  // of length 1, towards the last point
};
// The straight line with the least squares of distances; nothing for less than three points.
std::optional<FittedLine> fit(const Points& points);
std::optional<Vec2> meeting_of(const FittedLine& one, const FittedLine& other);

// Returns the way from the first point to each, dx.
std::vector<double> ways_along(const Points& points);

}  // namespace hackle
