// SPDX-License-Identifier: MIT
#pragma once

#include "scene/amplitude.hpp"
#include "scene/loads/guided.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A rigid disc in the plane of the plate, which a machine leads or holds, and which pushes the
// nodes it meets: a roller of a bending test.
struct Roller {
  Vec2 centre{0, 0};    // m, before it moves
  double radius = 0.0;  // m
  Guide guide = Guide::displacement;
  Vec2 value{0, 0};  // m or m/s, at amplitude 1
  Amplitude amplitude;
  double friction = 0.0;
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
    kind_member(&Roller::guide, &Roller::value, enum_names<Guide>, about_guide),
    member("time", &Roller::amplitude, about_amplitude),
    member("friction", &Roller::friction, about_friction));

template <>
inline constexpr Introduction introduction_of<Roller>{
    "Presses a rigid disc that is led, or held, against the plate, as in a bending test.",
    "p:roller { centre = {50*mm, 45*mm}, radius = 5*mm, velocity = {0, -2} }",
    "s:roller { centre = {50*mm, 45*mm}, radius = 5*mm, velocity = {0, -2} }",
    "platen impactor move"};

inline bool same_place(const Roller& one, const Roller& other) {
  return one.centre == other.centre && one.radius == other.radius;
}

}  // namespace hackle
