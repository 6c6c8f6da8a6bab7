// SPDX-License-Identifier: MIT
// All points within a radius of a segment: a slot with round ends.
#pragma once

#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/shapes/box.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct Capsule {
  Segment axis;
  double radius = 0.0;  // > 0
  friend bool operator==(const Capsule&, const Capsule&) = default;
};

template <>
inline constexpr auto description_of<Segment> = describe_noun(
    "segment", "segment", member("from", &Segment::from, {.unit = "m", .required = true}),
    member("to", &Segment::to, {.unit = "m", .required = true}));

template <>
inline constexpr auto description_of<Capsule> =
    describe_noun("slot", "slot", member("", &Capsule::axis),
                  member("radius", &Capsule::radius, {.unit = "m", .required = true}));

// The functions of every shape; see shape.hpp.
Box bounds_of(const Capsule& capsule);
Capsule moved(const Capsule& capsule, const Vec2& origin, double factor);
bool lies_inside(const Capsule& capsule, const Vec2& point, double tie);
bool covers_point(const Capsule& capsule, const Vec2& point, double tie);
bool cuts_segment(const Capsule& capsule, const Segment& segment, double tie);
bool may_cut_in(const Capsule& capsule, const Box& box, double tie);
void add_crossings_of(const Capsule& capsule, const Segment& segment, double tie,
                      std::vector<double>& crossings);
void check_shape(const Capsule& capsule, const std::string& who, Problems& problems);

}  // namespace hackle
