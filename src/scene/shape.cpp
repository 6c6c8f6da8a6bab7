// SPDX-License-Identifier: MIT
#include "scene/shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

// Where a point lies when the ellipse is made the unit circle.
Vec2 on_circle(const Ellipse& ellipse, const Vec2& point) {
  const Vec2 axis(std::cos(ellipse.angle), std::sin(ellipse.angle)), r = point - ellipse.centre;
  return Vec2(axis.dot(r), cross(axis, r)).cwiseQuotient(ellipse.radii);
}

// How deep a point lies inside; negative outside. Exact in sign, and in size near the rim.
double depth(const Ellipse& ellipse, const Vec2& point) {
  return (1.0 - on_circle(ellipse, point).norm()) * ellipse.radii.minCoeff();
}

template <class Work>
void for_sides(const Polygon& polygon, const Work& work) {
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k) work({polygon.points[k], polygon.points[(k + 1) % n]});
}

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

double depth(const Polygon& polygon, const Vec2& point) {
  double nearest = std::numeric_limits<double>::max();
  for_sides(polygon,
            [&](const Segment& side) { nearest = std::min(nearest, distance(side, point)); });
  return is_within(polygon, point) ? nearest : -nearest;
}

double depth(const Capsule& capsule, const Vec2& point) {
  return capsule.radius - distance(capsule.axis, point);
}

// Half a cell inside or outside; pictures have no rim.
double depth(const Bitmap& bitmap, const Vec2& point) {
  const Vec2 cell = (bitmap.most - bitmap.least).cwiseQuotient(Vec2(bitmap.columns, bitmap.rows));
  const Vec2 at = (point - bitmap.least).cwiseQuotient(cell);
  const auto i = static_cast<std::int64_t>(std::floor(at.x()));
  const auto j = static_cast<std::int64_t>(std::floor(at.y()));
  const bool on = i >= 0 && j >= 0 && i < bitmap.columns && j < bitmap.rows &&
                  bitmap.inside[static_cast<std::size_t>(j * bitmap.columns + i)] != 0;
  return (on ? 0.5 : -0.5) * cell.minCoeff();
}

bool cuts_shape(const Ellipse& ellipse, const Segment& segment, double tie) {
  const Segment seen{on_circle(ellipse, segment.from), on_circle(ellipse, segment.to)};
  return (1.0 - distance(seen, Vec2(0, 0))) * ellipse.radii.minCoeff() > tie;
}

bool cuts_shape(const Capsule& capsule, const Segment& segment, double tie) {
  return capsule.radius - distance(capsule.axis, segment) > tie;
}

// Cuts the segment where it meets a side and looks at the middle of every piece.
bool cuts_shape(const Polygon& polygon, const Segment& segment, double tie) {
  const Vec2 along = segment.to - segment.from;
  std::vector<double> meets{0.0, 1.0};
  for_sides(polygon, [&](const Segment& side) {
    const Vec2 across = side.to - side.from;
    const double area = cross(along, across);
    if (area == 0.0) return;
    const double t = cross(side.from - segment.from, across) / area;
    if (t > 0.0 && t < 1.0) meets.push_back(t);
  });
  std::ranges::sort(meets);
  for (std::size_t k = 0; k + 1 < meets.size(); ++k)
    if (depth(polygon, segment.from + 0.5 * (meets[k] + meets[k + 1]) * along) > tie) return true;
  return false;
}

bool cuts_shape(const Bitmap& bitmap, const Segment& segment, double tie) {
  const Vec2 cell = (bitmap.most - bitmap.least).cwiseQuotient(Vec2(bitmap.columns, bitmap.rows));
  const Vec2 along = segment.to - segment.from;
  const int pieces = 1 + static_cast<int>(2.0 * along.norm() / cell.minCoeff());
  for (int k = 0; k <= pieces; ++k)
    if (depth(bitmap, segment.from + (static_cast<double>(k) / pieces) * along) > tie) return true;
  return false;
}

Box bounds_of(const Ellipse& ellipse) {
  const Vec2 a = ellipse.radii.x() * Vec2(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Vec2 b = ellipse.radii.y() * Vec2(-std::sin(ellipse.angle), std::cos(ellipse.angle));
  const Vec2 half = (a.cwiseAbs2() + b.cwiseAbs2()).cwiseSqrt();
  return {ellipse.centre - half, ellipse.centre + half};
}

Box bounds_of(const Polygon& polygon) {
  Box box{polygon.points.front(), polygon.points.front()};
  for (const Vec2& point : polygon.points)
    box = {box.least.cwiseMin(point), box.most.cwiseMax(point)};
  return box;
}

Box bounds_of(const Capsule& capsule) {
  const Vec2 radius = Vec2::Constant(capsule.radius);
  return {capsule.axis.from.cwiseMin(capsule.axis.to) - radius,
          capsule.axis.from.cwiseMax(capsule.axis.to) + radius};
}

Box bounds_of(const Bitmap& bitmap) {
  return {bitmap.least, bitmap.most};
}

}  // namespace

Box bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return bounds_of(s); }, shape);
}

Shape transformed(const Shape& shape, const Vec2& origin, double factor) {
  const auto point = [&](const Vec2& p) -> Vec2 { return (p - origin) * factor; };
  struct Transform {
    const decltype(point)& move;
    double factor;
    Shape operator()(Ellipse s) const { return Ellipse{move(s.centre), s.radii * factor, s.angle}; }
    Shape operator()(Polygon s) const {
      std::ranges::transform(s.points, s.points.begin(), move);
      return s;
    }
    Shape operator()(const Capsule& s) const {
      return Capsule{{move(s.axis.from), move(s.axis.to)}, s.radius * factor};
    }
    Shape operator()(Bitmap s) const {
      s.least = move(s.least);
      s.most = move(s.most);
      return s;
    }
  };
  return std::visit(Transform{point, factor}, shape);
}

bool is_inside(const Shape& shape, const Vec2& point, double tie) {
  return std::visit([&](const auto& s) { return depth(s, point) > tie; }, shape);
}

bool covers(const Shape& shape, const Vec2& point, double tie) {
  return std::visit([&](const auto& s) { return depth(s, point) >= -tie; }, shape);
}

bool cuts(const Shape& shape, const Segment& segment, double tie) {
  return std::visit([&](const auto& s) { return cuts_shape(s, segment, tie); }, shape);
}

Shape rectangle(const Vec2& least, const Vec2& most) {
  return Polygon{{least, {most.x(), least.y()}, most, {least.x(), most.y()}}};
}

std::string kind_of(const Shape& shape) {
  constexpr const char* kinds[] = {"ellipse", "polygon", "slot", "picture"};
  return kinds[shape.index()];
}

void check(const Shape& shape, const std::string& who, Problems& problems) {
  const Box box = bounds(shape);
  const Vec2 size = box.most - box.least;
  if (size.allFinite() && size.minCoeff() > 0.0) return;
  problems.add(fmt::format("{}: the {} has no area", who, kind_of(shape)),
               "give it a size in both directions");
}

}  // namespace hackle
