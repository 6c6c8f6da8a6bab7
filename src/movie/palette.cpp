// SPDX-License-Identifier: MIT
#include "movie/palette.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace hackle {
namespace {

constexpr int bits = 6;  // per channel that distinguish colours

std::size_t cell_of(const Palette::Colour& colour) {
  constexpr int dropped = 8 - bits;
  return static_cast<std::size_t>(((colour.red >> dropped) << (2 * bits)) |
                                  ((colour.green >> dropped) << bits) | (colour.blue >> dropped));
}

int distance(const Palette::Colour& one, const Palette::Colour& other) {
  return std::max({std::abs(one.red - other.red), std::abs(one.green - other.green),
                   std::abs(one.blue - other.blue)});
}

// Distance (levels) below which an existing entry is reused; it grows as the palette fills.
int nearness(int taken) {
  if (taken < 128) return 3;
  if (taken < 192) return 8;
  return taken < 240 ? 20 : 48;
}

}  // namespace

Palette::Palette() : places_(std::size_t{1} << (3 * bits), transparent) {
}

std::uint8_t Palette::find_place(const Colour& colour) {
  int best = 0;
  for (int place = 1; place < taken_; ++place)
    if (distance(colours_[static_cast<std::size_t>(place)], colour) <
        distance(colours_[static_cast<std::size_t>(best)], colour))
      best = place;
  const bool near =
      taken_ > 0 && distance(colours_[static_cast<std::size_t>(best)], colour) <= nearness(taken_);
  if (near || taken_ == size) return static_cast<std::uint8_t>(best);
  colours_[static_cast<std::size_t>(taken_)] = colour;
  return static_cast<std::uint8_t>(taken_++);
}

std::uint8_t Palette::place_of(const Colour& colour) {
  std::uint8_t& place = places_[cell_of(colour)];
  if (place == transparent) place = find_place(colour);
  return place;
}

std::vector<std::uint8_t> Palette::places_of(const Image& image) {
  std::vector<std::uint8_t> places(image.pixels.size() / 4);
  const std::uint8_t* pixel = image.pixels.data();
  for (std::size_t k = 0; k < places.size(); ++k, pixel += 4) {
    const bool same = k > 0 && std::memcmp(pixel, pixel - 4, 3) == 0;
    places[k] = same ? places[k - 1] : place_of({pixel[2], pixel[1], pixel[0]});
  }
  return places;
}

}  // namespace hackle
