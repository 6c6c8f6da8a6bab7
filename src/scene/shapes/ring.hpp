// SPDX-License-Identifier: MIT
// The points between two circles of one centre.
#pragma once

#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/shapes/box.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct Ring {
  Vec2 centre{0, 0};
  double outer = 0.0;  // m, radius
  double inner = 0.0;  // m, radius, above 0 and below outer
  friend bool operator==(const Ring&, const Ring&) = default;
};

template <>
inline constexpr auto description_of<Ring> =
    describe_noun("ring", "ring", member("centre", &Ring::centre, {.unit = "m", .required = true}),
                  member("outer", &Ring::outer, {.unit = "m", .required = true}),
                  member("inner", &Ring::inner, {.unit = "m", .required = true}));

// The functions of every shape; see shape.hpp.
Box bounds_of(const Ring& ring);
Ring moved(const Ring& ring, const Vec2& origin, double factor);
bool lies_inside(const Ring& ring, const Vec2& point, double tie);
bool covers_point(const Ring& ring, const Vec2& point, double tie);
bool cuts_segment(const Ring& ring, const Segment& segment, double tie);
bool may_cut_in(const Ring& ring, const Box& box, double tie);
void add_crossings_of(const Ring& ring, const Segment& segment, double tie,
                      std::vector<double>& crossings);
void check_shape(const Ring& ring, const std::string& who, Problems& problems);

}  // namespace hackle
