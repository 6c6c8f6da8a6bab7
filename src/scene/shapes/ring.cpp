// SPDX-License-Identifier: MIT
#include "scene/shapes/ring.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.hpp"
#include "scene/geometry.hpp"
#include "scene/shapes/ellipse.hpp"

namespace hackle {
namespace {

double depth(const Ring& ring, const Vec2& point) {
  const double radius = (point - ring.centre).norm();
  return std::min(ring.outer - radius, radius - ring.inner);
}

}  // namespace

Box bounds_of(const Ring& ring) {
  return box_around(ring.centre, Vec2::Constant(ring.outer));
}

Ring moved(const Ring& ring, const Vec2& origin, double factor) {
  return {moved(ring.centre, origin, factor), ring.outer * factor, ring.inner * factor};
}

bool lies_inside(const Ring& ring, const Vec2& point, double tie) {
  return depth(ring, point) > tie;
}

bool covers_point(const Ring& ring, const Vec2& point, double tie) {
  return depth(ring, point) >= -tie;
}

// The distance to the centre takes every value between the least and the largest.
bool cuts_segment(const Ring& ring, const Segment& segment, double tie) {
  const double farthest =
      std::max((segment.from - ring.centre).norm(), (segment.to - ring.centre).norm());
  return ring.outer - distance(segment, ring.centre) > tie && farthest - ring.inner > tie;
}

bool may_cut_in(const Ring&, const Box&, double) {
  return true;
}

void add_crossings_of(const Ring& ring, const Segment& segment, double tie,
                      std::vector<double>& crossings) {
  for (const double radius : {ring.outer, ring.inner})
    add_crossings_of(Ellipse{ring.centre, Vec2::Constant(radius), 0.0}, segment, tie, crossings);
}

void check_shape(const Ring& ring, const std::string& who, Problems& problems) {
  check_area(bounds_of(ring), "ring", who, problems);
  if (ring.inner < ring.outer) return;
  problems.add(fmt::format("{}: the hole of the ring has a radius of {}, the ring of {}", who,
                           quantity(ring.inner, "m"), quantity(ring.outer, "m")),
               "inner is below radius");
}

}  // namespace hackle
