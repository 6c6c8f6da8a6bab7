// SPDX-License-Identifier: MIT
// What rigid bodies have in common that a machine leads: members of rollers and platens.
#pragma once

#include <array>

#include "base/described.hpp"

namespace hackle {

// By what its motion is given, at amplitude 1.
enum class Guide { displacement, velocity };

template <>
inline constexpr auto enum_names<Guide> = std::to_array<std::string_view>({"displacement",
                                                                           "velocity"});

inline constexpr auto about_guide = std::to_array<About>(
    {{.unit = "m",
      .fallback = "0",
      .sentence = "Its way from where it is described; without it stands still."},
     {.unit = "m/s", .alternative = true, .sentence = "Its velocity, instead of a displacement."}});

inline constexpr About about_friction{
    .range = between(0.0, 10.0),
    .fallback = "0",
    .sentence = "Coefficient of friction where it presses the plate."};

}  // namespace hackle
