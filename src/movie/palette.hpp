// SPDX-License-Identifier: MIT
// The colours of a GIF: taken as they are met, so that all frames share them and none flickers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.hpp"

namespace hackle {

// A colour met for the first time gets a place of its own as long as no place is near; what counts
// as near grows as places run out. The first half of them goes to colours that differ by four
// levels or more; a picture of one colour map and a few plain colours is exact to four levels.
class Palette {
 public:
  struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
  };
  // The last place is kept for what is transparent.
  static constexpr int size = 255;
  static constexpr std::uint8_t transparent = 255;

  Palette();

  // The place of each pixel's colour, row by row from the top.
  std::vector<std::uint8_t> places_of(const Image& image);

  int taken() const { return taken_; }  // so many of the places
  const std::array<Colour, size + 1>& colours() const { return colours_; }

 private:
  std::uint8_t place_of(const Colour& colour);
  std::uint8_t find_place(const Colour& colour);

  std::array<Colour, size + 1> colours_{};
  int taken_ = 0;
  std::vector<std::uint8_t> places_;  // of colours to six bits each; `transparent`: not met yet
};

}  // namespace hackle
