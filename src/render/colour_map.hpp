// SPDX-License-Identifier: MIT
// A table of colours from the least to the largest value of a field.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hackle {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;  // sRGB
  friend bool operator==(const Colour&, const Colour&) = default;
};

struct ColourMap {
  std::string name;
  std::array<Colour, 256> colours;
};

// The map of assets/colour_maps/NAME.csv. Throws Error (refused) for an unknown name, with the
// nearest one, and Error (files) for a damaged file.
ColourMap load_colour_map(const std::string& name);

// Names of all maps, in alphabetical order.
std::vector<std::string> colour_map_names();

}  // namespace hackle
