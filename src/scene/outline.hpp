// SPDX-License-Identifier: MIT
// The part of its rectangle that a plate keeps: everything covered by any of some areas. The rest
// is void.
#pragma once

#include <string>
#include <vector>

#include "scene/shape.hpp"

namespace hackle {

struct Outline {
  std::vector<Shape> areas;  // at least one
  std::string name;          // for loads to find its rim; "" for none
};

template <>
inline constexpr auto description_of<Outline> = describe_noun(
    "outline", "outline", member("areas", &Outline::areas, {.required = true}),
    member("name", &Outline::name,
           {.alternative = true,
            .sentence = "Name for p:pressure and p:traction to find the rim; several rims may "
                        "share one."}));

Box bounds(const Outline& outline);
Outline transformed(const Outline& outline, const Vec2& origin, double factor);

// Returns whether a point is inside or on the rim of an area.
bool covers(const Outline& outline, const Vec2& point, double tie);
// Returns whether any point of a segment is outside all areas, farther than `tie` from their rims.
bool leaves(const Outline& outline, const Segment& segment, double tie);

}  // namespace hackle
