// SPDX-License-Identifier: MIT
// Any closed chain of straight sides, convex or not; the even-odd rule decides what is inside.
#pragma once

#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/shapes/box.hpp"
#include "scene/vec2.hpp"

namespace hackle {

inline constexpr double max_points = 10000;  // per polygon or crack

struct Polygon {
  std::vector<Vec2> points;  // at least three
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

template <>
inline constexpr auto description_of<Polygon> =
    describe_noun("polygon", "polygon",
                  member("points", &Polygon::points,
                         {.unit = "m", .range = between(3, max_points), .required = true}));

// The functions of every shape; see shape.hpp.
Box bounds_of(const Polygon& polygon);
Polygon moved(Polygon polygon, const Vec2& origin, double factor);
bool lies_inside(const Polygon& polygon, const Vec2& point, double tie);
bool covers_point(const Polygon& polygon, const Vec2& point, double tie);
bool cuts_segment(const Polygon& polygon, const Segment& segment, double tie);
bool may_cut_in(const Polygon& polygon, const Box& box, double tie);
void add_crossings_of(const Polygon& polygon, const Segment& segment, double tie,
                      std::vector<double>& crossings);
void check_shape(const Polygon& polygon, const std::string& who, Problems& problems);

}  // namespace hackle
