// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/loads/guided.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A rigid disc in the plane of the plate, which flies freely and pushes the nodes it meets.
struct Impactor {
  Vec2 centre{0, 0};    // m, at t = 0
  double radius = 0.0;  // m
  Vec2 velocity{0, 0};  // m/s, at t = 0
  double mass = 0.0;    // kg per m of thickness
  double friction = 0.0;
  double restitution = 1.0;
  std::string name;  // "" for none
};

template <>
inline constexpr auto description_of<Impactor> = describe_noun(
    "impactor", "impactor",
    member("centre", &Impactor::centre,
           {.unit = "m",
            .required = true,
            .sentence = "Initial position: outside the plate as it is drawn, or in a hole."}),
    member("radius", &Impactor::radius,
           {.unit = "m",
            .range = above(0.0),
            .required = true,
            .sentence = "Radius, at least one spacing."}),
    member("velocity", &Impactor::velocity,
           {.unit = "m/s",
            .required = true,
            .sentence = "Initial velocity; afterwards it flies freely."}),
    member("mass", &Impactor::mass,
           {.unit = "kg/m",
            .range = above(0.0),
            .alternative = true,
            .sentence = "Mass per metre of thickness, instead of a density."}),
    member("friction", &Impactor::friction, about_friction),
    member("restitution", &Impactor::restitution,
           {.range = between(0.0, 1.0),
            .fallback = "1",
            .sentence = "Speed after a rebound over that before it, apart from what waves carry "
                        "away."}),
    member("name", &Impactor::name, about_load_name));

// Never: a disc moves, so a new one does not replace it.
inline bool same_place(const Impactor&, const Impactor&) {
  return false;
}

}  // namespace hackle
