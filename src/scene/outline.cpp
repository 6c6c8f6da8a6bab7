// SPDX-License-Identifier: MIT
#include "scene/outline.hpp"

#include <algorithm>
#include <utility>

namespace hackle {

Box bounds(const Outline& outline) {
  Box box = bounds(outline.areas.front());
  for (const Shape& area : outline.areas) {
    const Box next = bounds(area);
    box = {box.min.cwiseMin(next.min), box.max.cwiseMax(next.max)};
  }
  return box;
}

Outline transformed(const Outline& outline, const Vec2& origin, double factor) {
  Outline result{{}, outline.name};
  for (const Shape& area : outline.areas) result.areas.push_back(transformed(area, origin, factor));
  return result;
}

bool covers(const Outline& outline, const Vec2& point, double tie) {
  return std::ranges::any_of(outline.areas,
                             [&](const Shape& area) { return covers(area, point, tie); });
}

bool leaves(const Outline& outline, const Segment& segment, double tie) {
  std::vector<double> crossings;
  for (const Shape& area : outline.areas) add_crossings(area, segment, tie, crossings);
  const auto is_outside = [&](const Vec2& point) { return !covers(outline, point, tie); };
  return is_outside(segment.from) || is_outside(segment.to) ||
         any_midpoint(segment, std::move(crossings), is_outside);
}

}  // namespace hackle
