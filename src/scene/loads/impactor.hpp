// SPDX-License-Identifier: MIT
#pragma once

#include "base/described.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A rigid disc in the plane of the plate that flies freely and pushes what it meets.
struct Impactor {
  Vec2 centre{0, 0};    // m, at the start
  double radius = 0.0;  // m
  Vec2 velocity{0, 0};  // m/s, at the start
  double mass = 0.0;    // kg/m of thickness
};

template <>
inline constexpr auto description_of<Impactor> = describe_noun(
    "impactor", "impactor",
    member("centre", &Impactor::centre,
           {.unit = "m",
            .required = true,
            .sentence = "Where it starts, beside the plate as it is drawn, or in a hole."}),
    member("radius", &Impactor::radius,
           {.unit = "m", .range = above(0.0), .required = true, .sentence = "At least a spacing."}),
    member("velocity", &Impactor::velocity,
           {.unit = "m/s",
            .required = true,
            .sentence = "With which it starts; then it flies freely."}),
    member("mass", &Impactor::mass,
           {.unit = "kg/m",
            .range = above(0.0),
            .alternative = true,
            .sentence = "Per metre of thickness, instead of a density."}));

// It is on its way: no other disc takes its place.
inline bool same_place(const Impactor&, const Impactor&) {
  return false;
}

}  // namespace hackle
