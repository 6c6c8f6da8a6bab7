// SPDX-License-Identifier: MIT
// An ellipse; a circle is one of equal half axes.
#pragma once

#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/shapes/box.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct Ellipse {
  Vec2 centre{0, 0};
  Vec2 radii{0, 0};    // half axes, > 0
  double angle = 0.0;  // rad, first half axis from x, anticlockwise
  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

template <>
inline constexpr auto description_of<Ellipse> = describe_noun(
    "ellipse", "ellipse", member("centre", &Ellipse::centre, {.unit = "m", .required = true}),
    member("radii", &Ellipse::radii, {.unit = "m", .required = true}),
    member("angle", &Ellipse::angle, {.unit = "rad", .fallback = "0"}));

// The functions of every shape; see shape.hpp.
Box bounds_of(const Ellipse& ellipse);
Ellipse moved(const Ellipse& ellipse, const Vec2& origin, double factor);
bool lies_inside(const Ellipse& ellipse, const Vec2& point, double tie);
bool covers_point(const Ellipse& ellipse, const Vec2& point, double tie);
bool cuts_segment(const Ellipse& ellipse, const Segment& segment, double tie);
bool may_cut_in(const Ellipse& ellipse, const Box& box, double tie);
void add_crossings_of(const Ellipse& ellipse, const Segment& segment, double tie,
                      std::vector<double>& crossings);
void check_shape(const Ellipse& ellipse, const std::string& who, Problems& problems);

}  // namespace hackle
