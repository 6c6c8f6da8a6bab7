// SPDX-License-Identifier: MIT
// The colours of a GIF: added as they occur, so that all frames share them and none flickers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.hpp"

namespace hackle {

// A new colour gets its own entry unless an entry is near; the threshold of nearness grows as the
// palette fills. The first half goes to colours that differ by four levels or more; a picture of
// one colour map and a few plain colours is exact to four levels.
class Palette {
 public:
  struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
  };
  // The last entry is reserved for transparent pixels.
  static constexpr int size = 255;
  static constexpr std::uint8_t transparent = 255;

  Palette();

  // Returns the entry of each pixel's colour, row by row from the top.
  std::vector<std::uint8_t> places_of(const Image& image);

  int taken() const { return taken_; }  // number of used entries
  const std::array<Colour, size + 1>& colours() const { return colours_; }

 private:
  std::uint8_t place_of(const Colour& colour);
  std::uint8_t find_place(const Colour& colour);

  std::array<Colour, size + 1> colours_{};
  int taken_ = 0;
  // of colours with six bits per channel; `transparent`: not used yet
  std::vector<std::uint8_t> places_;
};

}  // namespace hackle
