// SPDX-License-Identifier: MIT
// A table of colours from the smallest to the largest value of a field.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hackle {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;  // sRGB
  friend bool operator==(const Colour&, const Colour&) = default;
};

struct ColourMap {
  std::string name;
  // at equal distances from the smallest to the largest value, at least two
  std::vector<Colour> colours;
};

// Each has a file in assets/colour_maps; in alphabetical order.
inline constexpr auto colour_map_names = std::to_array<std::string_view>(
    {"batlow", "cividis", "damage", "ember", "inferno", "lagoon", "roma", "vik", "viridis"});

// Returns the brightness in a dark-field polariscope, sin^2(pi N), for fringe orders N from `least`
// to `most`.
ColourMap fringe_map(double min, double max);

// Loads assets/colour_maps/NAME.csv. Throws Error (refused) for an unknown name, with the nearest
// one, and Error (files) for a damaged file.
ColourMap load_colour_map(const std::string& name);

}  // namespace hackle
