// SPDX-License-Identifier: MIT
#include "scene/shapes/ellipse.hpp"

#include <cmath>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

// Maps a point by the map that makes the ellipse the unit circle.
Vec2 on_circle(const Ellipse& ellipse, const Vec2& point) {
  const Vec2 axis(std::cos(ellipse.angle), std::sin(ellipse.angle)), r = point - ellipse.centre;
  return Vec2(axis.dot(r), cross(axis, r)).cwiseQuotient(ellipse.radii);
}

// Returns the depth of a point inside, negative outside. Its sign is exact, its size only near the
// rim.
double depth(const Ellipse& ellipse, const Vec2& point) {
  return (1.0 - on_circle(ellipse, point).norm()) * ellipse.radii.minCoeff();
}

}  // namespace

Box bounds_of(const Ellipse& ellipse) {
  const Vec2 a = ellipse.radii.x() * Vec2(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Vec2 b = ellipse.radii.y() * Vec2(-std::sin(ellipse.angle), std::cos(ellipse.angle));
  return box_around(ellipse.centre, (a.cwiseAbs2() + b.cwiseAbs2()).cwiseSqrt());
}

Ellipse moved(const Ellipse& ellipse, const Vec2& origin, double factor) {
  return {moved(ellipse.centre, origin, factor), ellipse.radii * factor, ellipse.angle};
}

bool lies_inside(const Ellipse& ellipse, const Vec2& point, double tie) {
  return depth(ellipse, point) > tie;
}

bool covers_point(const Ellipse& ellipse, const Vec2& point, double tie) {
  return depth(ellipse, point) >= -tie;
}

bool cuts_segment(const Ellipse& ellipse, const Segment& segment, double tie) {
  const Segment seen{on_circle(ellipse, segment.from), on_circle(ellipse, segment.to)};
  return (1.0 - distance(seen, Vec2(0, 0))) * ellipse.radii.minCoeff() > tie;
}

bool may_cut_in(const Ellipse&, const Box&, double) {
  return true;
}

// Where |from + t along| is 1 on the unit circle.
void add_crossings_of(const Ellipse& ellipse, const Segment& segment, double,
                      std::vector<double>& crossings) {
  const Vec2 from = on_circle(ellipse, segment.from), along = on_circle(ellipse, segment.to) - from;
  const double a = along.squaredNorm(), b = from.dot(along), c = from.squaredNorm() - 1.0;
  const double root = b * b - a * c;
  if (!(a > 0.0) || root < 0.0) return;
  for (const double t : {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a})
    if (t > 0.0 && t < 1.0) crossings.push_back(t);
}

void check_shape(const Ellipse& ellipse, const std::string& who, Problems& problems) {
  check_area(bounds_of(ellipse), "ellipse", who, problems);
}

}  // namespace hackle
