// SPDX-License-Identifier: MIT
#include "scene/shapes/polygon.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

template <class Work>
void for_sides(const Polygon& polygon, const Work& work) {
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k) work({polygon.points[k], polygon.points[(k + 1) % n]});
}

// Applies the even-odd rule; undefined for points on the rim.
bool is_within(const Polygon& polygon, const Vec2& point) {
  bool within = false;
  for_sides(polygon, [&](const Segment& side) {
    const bool spans = (side.from.y() > point.y()) != (side.to.y() > point.y());
    if (!spans) return;
    const double t = (point.y() - side.from.y()) / (side.to.y() - side.from.y());
    if (point.x() < side.from.x() + t * (side.to.x() - side.from.x())) within = !within;
  });
  return within;
}

bool is_on_rim(const Polygon& polygon, const Vec2& point, double tie) {
  bool on_rim = false;
  for_sides(polygon, [&](const Segment& side) {
    if (is_near(side, {point, point}, tie)) on_rim = on_rim || distance(side, point) <= tie;
  });
  return on_rim;
}

// Returns whether all points lie on one line, up to rounding.
bool is_flat(const Polygon& polygon) {
  const Vec2& first = polygon.points.front();
  const auto away = [&](const Vec2& p) { return (p - first).squaredNorm(); };
  const Vec2 far = *std::ranges::max_element(polygon.points, {}, away);
  const Vec2 along = far - first;
  return std::ranges::all_of(polygon.points, [&](const Vec2& p) {
    return std::abs(cross(along, p - first)) <= 1e-12 * along.squaredNorm();
  });
}

}  // namespace

Box bounds_of(const Polygon& polygon) {
  Box box{polygon.points.front(), polygon.points.front()};
  for (const Vec2& point : polygon.points) box = {box.min.cwiseMin(point), box.max.cwiseMax(point)};
  return box;
}

Polygon moved(Polygon polygon, const Vec2& origin, double factor) {
  for (Vec2& point : polygon.points) point = moved(point, origin, factor);
  return polygon;
}

bool lies_inside(const Polygon& polygon, const Vec2& point, double tie) {
  return is_within(polygon, point) && !is_on_rim(polygon, point, tie);
}

bool covers_point(const Polygon& polygon, const Vec2& point, double tie) {
  return is_within(polygon, point) || is_on_rim(polygon, point, tie);
}

bool cuts_segment(const Polygon& polygon, const Segment& segment, double tie) {
  std::vector<double> crossings;
  add_crossings_of(polygon, segment, tie, crossings);
  return any_midpoint(segment, std::move(crossings),
                      [&](const Vec2& point) { return lies_inside(polygon, point, tie); });
}

bool may_cut_in(const Polygon& polygon, const Box& box, double tie) {
  bool near = is_within(polygon, box.min);
  for_sides(polygon, [&](const Segment& side) { near = near || is_near(side, box, tie); });
  return near;
}

void add_crossings_of(const Polygon& polygon, const Segment& segment, double tie,
                      std::vector<double>& crossings) {
  const Box box{segment.from.cwiseMin(segment.to), segment.from.cwiseMax(segment.to)};
  for_sides(polygon, [&](const Segment& side) {
    if (is_near(side, box, tie)) add_crossing_of_side(side, segment, crossings);
  });
}

void check_shape(const Polygon& polygon, const std::string& who, Problems& problems) {
  if (polygon.points.size() < 3)
    return problems.add(fmt::format("{}: a polygon has at least three points", who));
  const Box box = bounds_of(polygon);
  const bool flat = (box.max - box.min).allFinite() && is_flat(polygon);
  check_area(flat ? Box{} : box, "polygon", who, problems);
}

}  // namespace hackle
