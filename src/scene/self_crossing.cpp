// SPDX-License-Identifier: MIT
#include "scene/self_crossing.hpp"

#include <algorithm>
#include <numeric>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

std::vector<Segment> sides_of(const Polygon& polygon) {
  std::vector<Segment> sides;
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k)
    sides.push_back({polygon.points[k], polygon.points[(k + 1) % n]});
  return sides;
}

// Returns whether the ends of `other` lie on different sides of the line through `one`, beyond
// rounding.
bool parts(const Segment& one, const Segment& other) {
  const Vec2 along = one.to - one.from;
  const double size = along.norm() + (other.to - other.from).norm();
  const double tie = 1e-12 * along.norm() * size;
  const double from = cross(along, other.from - one.from), to = cross(along, other.to - one.from);
  return (from > tie && to < -tie) || (from < -tie && to > tie);
}

double left_end(const Segment& segment) {
  return std::min(segment.from.x(), segment.to.x());
}

double right_end(const Segment& segment) {
  return std::max(segment.from.x(), segment.to.x());
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> crossing_sides(const Polygon& polygon) {
  const std::vector<Segment> sides = sides_of(polygon);
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return left_end(sides[k]); });
  for (auto one = order.begin(); one != order.end(); ++one)
    for (auto other = one + 1; other != order.end(); ++other) {
      if (left_end(sides[*other]) > right_end(sides[*one])) break;
      if (parts(sides[*one], sides[*other]) && parts(sides[*other], sides[*one]))
        return std::pair(std::min(*one, *other), std::max(*one, *other));
    }
  return std::nullopt;
}

}  // namespace hackle
