// SPDX-License-Identifier: MIT
// Boxes along the axes, and functions shared by shapes.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct Box {
  Vec2 min{0, 0};
  Vec2 max{0, 0};
};

inline Box box_around(const Vec2& centre, const Vec2& half) {
  return {centre - half, centre + half};
}

// Returns the point as seen from `origin`, scaled.
inline Vec2 moved(const Vec2& point, const Vec2& origin, double factor) {
  return (point - origin) * factor;
}

// Returns whether the bounding box of a segment, enlarged by `margin`, meets another box.
bool is_near(const Segment& segment, const Box& box, double margin);

// Adds a problem when a box has no area.
void check_area(const Box& box, std::string_view kind, const std::string& who, Problems& problems);

// Appends the place along a segment, above 0 and below 1, where it meets the line of a side.
void add_crossing_of_side(const Segment& side, const Segment& segment,
                          std::vector<double>& crossings);

// Calls test(point) for the midpoint of every part of a segment between crossings, in any order,
// until one is true; returns whether one was.
template <class Test>
bool any_midpoint(const Segment& segment, std::vector<double> crossings, const Test& test) {
  crossings.push_back(0.0);
  crossings.push_back(1.0);
  std::ranges::sort(crossings);
  const Vec2 along = segment.to - segment.from;
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k)
    if (test(Vec2(segment.from + 0.5 * (crossings[k] + crossings[k + 1]) * along))) return true;
  return false;
}

}  // namespace hackle
