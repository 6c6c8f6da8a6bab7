// SPDX-License-Identifier: MIT
// What rollers and platens share: rigid bodies that a machine leads against the plate.
#pragma once

#include <array>
#include <string>

#include "base/described.hpp"
#include "scene/amplitude.hpp"
#include "scene/loads/load_name.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// By what its motion is given, at amplitude 1.
enum class Guide { displacement, velocity, force };

template <>
inline constexpr auto enum_names<Guide> = std::to_array<std::string_view>({"displacement",
                                                                           "velocity", "force"});

inline constexpr About about_friction{
    .range = between(0.0, 10.0),
    .fallback = "0",
    .sentence = "Coefficient of friction where it presses the plate."};

inline constexpr double density_of_steel = 7850.0;  // kg/m3

// How the machine leads a body. By a force it leads it along the line of the force: the body moves
// there as its mass demands, and not at all across.
struct Guided {
  Guide guide = Guide::displacement;
  Vec2 value{0, 0};  // m, m/s, or N per m of thickness, at amplitude 1
  Amplitude amplitude;
  double friction = 0.0;
  double mass = 0.0;  // kg per m of thickness, with a force; 0: that of a body of steel
  std::string name;   // "" for none
};

template <>
inline constexpr auto description_of<Guided> = describe_noun(
    "guided body", "guided body",
    kind_member(
        &Guided::guide, &Guided::value, enum_names<Guide>,
        std::to_array<About>(
            {{.unit = "m",
              .fallback = "0",
              .sentence = "Its way from where it is described; without it stands still."},
             {.unit = "m/s",
              .alternative = true,
              .sentence = "Its velocity, instead of a displacement."},
             {.unit = "N/m",
              .alternative = true,
              .sentence = "The force on it per metre of thickness, instead of a displacement: it "
                          "starts at rest and moves along the force only."}})),
    member("time", &Guided::amplitude, about_amplitude),
    member("friction", &Guided::friction, about_friction),
    member("mass", &Guided::mass,
           {.unit = "kg/m",
            .range = above(0.0),
            .fallback = "steel",
            .sentence = "Its mass per metre of thickness, with a force."}),
    member("name", &Guided::name, about_load_name));

// Returns the mass of a guided body of this area (m2), kg/m.
inline double mass_of(const Guided& guided, double area) {
  return guided.mass > 0.0 ? guided.mass : density_of_steel * area;
}

}  // namespace hackle
