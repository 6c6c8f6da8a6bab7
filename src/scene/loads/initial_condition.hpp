// SPDX-License-Identifier: MIT
#pragma once

#include "scene/field_of_place.hpp"
#include "scene/shape.hpp"

namespace hackle {

// Displacement and velocity at t = 0. Conditions add up where their regions overlap.
struct InitialCondition {
  Region region;
  VectorField displacement;  // m
  VectorField velocity;      // m/s
};

template <>
inline constexpr auto description_of<InitialCondition> = describe_noun(
    "initial", "initial condition", member("region", &InitialCondition::region, about_region),
    member("displacement", &InitialCondition::displacement,
           {.unit = "m", .alternative = true, .sentence = "Displacement at time zero."}),
    member("velocity", &InitialCondition::velocity,
           {.unit = "m/s", .alternative = true, .sentence = "Velocity at time zero."}));

}  // namespace hackle
