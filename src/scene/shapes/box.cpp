// SPDX-License-Identifier: MIT
#include "scene/shapes/box.hpp"

#include <fmt/format.h>

#include "scene/geometry.hpp"

namespace hackle {

bool is_near(const Segment& segment, const Box& box, double margin) {
  return std::min(segment.from.x(), segment.to.x()) <= box.max.x() + margin &&
         std::max(segment.from.x(), segment.to.x()) >= box.min.x() - margin &&
         std::min(segment.from.y(), segment.to.y()) <= box.max.y() + margin &&
         std::max(segment.from.y(), segment.to.y()) >= box.min.y() - margin;
}

void check_area(const Box& box, std::string_view kind, const std::string& who, Problems& problems) {
  const Vec2 size = box.max - box.min;
  if (size.allFinite() && size.minCoeff() > 0.0) return;
  problems.add(fmt::format("{}: the {} has no area", who, kind),
               "give it a size in both directions");
}

void add_crossing_of_side(const Segment& side, const Segment& segment,
                          std::vector<double>& crossings) {
  const Vec2 across = side.to - side.from;
  const double area = cross(segment.to - segment.from, across);
  if (area == 0.0) return;
  const double t = cross(side.from - segment.from, across) / area;
  if (t > 0.0 && t < 1.0) crossings.push_back(t);
}

}  // namespace hackle
