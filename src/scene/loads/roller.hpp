// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "scene/loads/guided.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A rigid disc in the plane of the plate, which a machine leads, presses or holds, and which pushes
// the nodes it meets: a roller of a bending test.
struct Roller {
  Vec2 centre{0, 0};    // m, before it moves
  double radius = 0.0;  // m
  Guided guided;
};

template <>
inline constexpr auto description_of<Roller> = describe_noun(
    "roller", "roller",
    member("centre", &Roller::centre,
           {.unit = "m",
            .required = true,
            .sentence = "Position before it moves: outside the plate as it is drawn, or in a "
                        "hole."}),
    member("radius", &Roller::radius,
           {.unit = "m",
            .range = above(0.0),
            .required = true,
            .sentence = "Radius, at least one spacing."}),
    member("", &Roller::guided));

template <>
inline constexpr Introduction introduction_of<Roller>{
    "Presses a rigid disc that is led, or held, against the plate, as in a bending test.",
    "p:roller { centre = {50*mm, 45*mm}, radius = 5*mm, velocity = {0, -2} }\n"
    "p:roller { centre = {50*mm, -5*mm}, radius = 5*mm, force = {0, 1e5} }",
    "s:roller { centre = {50*mm, 45*mm}, radius = 5*mm, velocity = {0, -2} }",
    "platen impactor move"};

// Return the greatest width of what it may press at a time, m, and its area, m2.
inline double breadth_of(const Roller& roller) {
  return 2.0 * roller.radius;
}
inline double area_of(const Roller& roller) {
  return std::numbers::pi * roller.radius * roller.radius;
}

inline bool same_place(const Roller& one, const Roller& other) {
  return one.centre == other.centre && one.radius == other.radius;
}

}  // namespace hackle
