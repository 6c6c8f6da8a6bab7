// SPDX-License-Identifier: MIT
// Regular polygons and stars, as polygons.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "scene/shape.hpp"

namespace hackle {

inline constexpr double max_corners = 1000;

// Makes a polygon with `corners` corners (at least 3) at `radius` from the centre, the first at
// `angle` (rad) from x, the others anticlockwise. With `inner` there is another corner at that
// radius halfway between neighbours. If the line through the centre and the first corner runs along
// x, the polygon is exactly symmetric about it.
inline Polygon star(const Vec2& centre, double radius, int corners, double angle = 0.0,
                    std::optional<double> inner = std::nullopt) {
  const int count = inner ? 2 * corners : corners;
  const Vec2 first(std::cos(angle), std::sin(angle)), across(-first.y(), first.x());
  Polygon polygon;
  for (int k = 0; k < count; ++k) {
    const double turn = 2.0 * std::numbers::pi * std::min(k, count - k) / count;
    const double side = 2 * k > count ? -std::sin(turn) : std::sin(turn);
    const double r = inner && k % 2 == 1 ? *inner : radius;
    polygon.points.emplace_back(centre + r * (std::cos(turn) * first + side * across));
  }
  return polygon;
}

}  // namespace hackle
