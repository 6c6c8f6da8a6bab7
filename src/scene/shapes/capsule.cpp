// SPDX-License-Identifier: MIT
#include "scene/shapes/capsule.hpp"

#include "scene/geometry.hpp"
#include "scene/shapes/ellipse.hpp"

namespace hackle {
namespace {

double depth(const Capsule& capsule, const Vec2& point) {
  return capsule.radius - distance(capsule.axis, point);
}

}  // namespace

Box bounds_of(const Capsule& capsule) {
  const Vec2 radius = Vec2::Constant(capsule.radius);
  return {capsule.axis.from.cwiseMin(capsule.axis.to) - radius,
          capsule.axis.from.cwiseMax(capsule.axis.to) + radius};
}

Capsule moved(const Capsule& capsule, const Vec2& origin, double factor) {
  return {{moved(capsule.axis.from, origin, factor), moved(capsule.axis.to, origin, factor)},
          capsule.radius * factor};
}

bool lies_inside(const Capsule& capsule, const Vec2& point, double tie) {
  return depth(capsule, point) > tie;
}

bool covers_point(const Capsule& capsule, const Vec2& point, double tie) {
  return depth(capsule, point) >= -tie;
}

bool cuts_segment(const Capsule& capsule, const Segment& segment, double tie) {
  return capsule.radius - distance(capsule.axis, segment) > tie;
}

bool may_cut_in(const Capsule&, const Box&, double) {
  return true;
}

// The two circles at its ends, and the two lines beside its axis.
void add_crossings_of(const Capsule& capsule, const Segment& segment, double tie,
                      std::vector<double>& crossings) {
  for (const Vec2& end : {capsule.axis.from, capsule.axis.to})
    add_crossings_of(Ellipse{end, Vec2::Constant(capsule.radius), 0.0}, segment, tie, crossings);
  const Vec2 along = capsule.axis.to - capsule.axis.from;
  const double length = along.norm();
  if (length == 0.0) return;
  const Vec2 aside = Vec2(-along.y(), along.x()) * (capsule.radius / length);
  for (const double sign : {-1.0, 1.0})
    add_crossing_of_side({capsule.axis.from + sign * aside, capsule.axis.to + sign * aside},
                         segment, crossings);
}

void check_shape(const Capsule& capsule, const std::string& who, Problems& problems) {
  check_area(bounds_of(capsule), "slot", who, problems);
}

}  // namespace hackle
