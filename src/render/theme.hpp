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

// The whole of a picture: its ground, texts, charts and colour maps.
enum class Look { dark, light };
template <>
inline constexpr auto enum_names<Look> = std::to_array<std::string_view>({"dark", "light"});

struct Theme {
  Colour background;
  double opacity = 1.0;  // of the background, 0 or 1
  Colour text;           // titles, time, names
  Colour quiet;          // numbers and remarks
  Colour outline;        // rim of the plate, lines of charts
  Colour disc;           // impactors, rollers and platens
  Colour gap;            // cracks shown as gaps, seen on any colour of a field; with `opacity`
  // For the curves of a chart, in order; distinguishable for colour-blind people.
  std::array<Colour, 5> curves;
};

const Theme& theme_of(Background background);

// The ground of a look.
constexpr Background ground_of(Look look) {
  return look == Look::light ? Background::light : Background::dark;
}

// Returns the colour map for a field that usually has this one: a light plate is nearly white where
// its values are least.
std::string_view colours_for(Look look, std::string_view usual);

// The colour of Background::dark.
inline constexpr Colour background_colour{15, 18, 24};

}  // namespace hackle
