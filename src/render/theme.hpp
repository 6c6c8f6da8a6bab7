// SPDX-License-Identifier: MIT
// The colours of everything except the field.
#pragma once

#include <array>
#include <string_view>

#include "base/described.hpp"
#include "render/colour_map.hpp"

namespace hackle {

// The colour where there is no material. Transparent pictures have the texts of light ones.
enum class Background { dark, light, transparent };
template <>
inline constexpr auto enum_names<Background> = std::to_array<std::string_view>({"dark", "light",
                                                                                "transparent"});

struct Theme {
  Colour background;
  double opacity = 1.0;  // of the background, 0 or 1
  Colour text;           // titles, time, names
  Colour quiet;          // numbers and remarks
  Colour outline;        // rim of the plate, lines of charts
  Colour disc;           // impactors
  // For the curves of a chart, in order; distinguishable for colour-blind people.
  std::array<Colour, 5> curves;
};

const Theme& theme_of(Background background);

// The colour of Background::dark.
inline constexpr Colour background_colour{15, 18, 24};

}  // namespace hackle
