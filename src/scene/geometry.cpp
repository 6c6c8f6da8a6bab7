// SPDX-License-Identifier: MIT
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

// Two segments on one line: do their ranges along it overlap?
bool overlap_on_line(const Segment& one, const Segment& other, double tie) {
  const Vec2 along = (one.to - one.from).normalized();
  const auto at = [&](const Vec2& point) { return along.dot(point - one.from); };
  const auto [least, most] = std::minmax({at(other.from), at(other.to)});
  return most > tie && least < at(one.to) - tie;
}

bool cross_properly(const Segment& one, const Segment& other) {
  return side(one, other.from, 0.0) * side(one, other.to, 0.0) <= 0 &&
         side(other, one.from, 0.0) * side(other, one.to, 0.0) <= 0;
}

bool is_point(const Segment& segment) {
  return segment.from == segment.to;
}

}  // namespace

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

int side(const Segment& segment, const Vec2& point, double tie) {
  const Vec2 along = segment.to - segment.from;
  // Measured from the middle, so that exchanging the ends flips the sign exactly.
  const double distance = cross(along, point - 0.5 * (segment.from + segment.to)) / along.norm();
  return std::abs(distance) <= tie ? 0 : (distance > 0.0 ? 1 : -1);
}

double distance(const Segment& segment, const Vec2& point) {
  const Vec2 middle = 0.5 * (segment.from + segment.to), half = 0.5 * (segment.to - segment.from);
  const double length2 = half.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(half.dot(point - middle) / length2, -1.0, 1.0) : 0.0;
  return (point - middle - t * half).norm();
}

double distance(const Segment& one, const Segment& other) {
  if (!is_point(one) && !is_point(other) && cross_properly(one, other)) {
    const bool parallel = cross(one.to - one.from, other.to - other.from) == 0.0;
    if (!parallel) return 0.0;
  }
  return std::min({distance(one, other.from), distance(one, other.to), distance(other, one.from),
                   distance(other, one.to)});
}

bool crosses(const Segment& one, const Segment& other, double tie) {
  const int from = side(one, other.from, tie), to = side(one, other.to, tie);
  if (from * to > 0) return false;
  if (from == 0 && to == 0) return overlap_on_line(one, other, tie);
  return side(other, one.from, tie) * side(other, one.to, tie) < 0;
}

}  // namespace hackle
