// SPDX-License-Identifier: MIT
#include "movie/palette.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace hackle {
namespace {

using Colour = Palette::Colour;

// Makes one row of pixels.
Image row_of(const std::vector<Colour>& colours) {
  Image image(static_cast<int>(colours.size()), 1);
  for (std::size_t k = 0; k < colours.size(); ++k) {
    image.pixels[4 * k] = colours[k].blue;
    image.pixels[4 * k + 1] = colours[k].green;
    image.pixels[4 * k + 2] = colours[k].red;
  }
  return image;
}

int farthest(const Colour& one, const Colour& other) {
  return std::max({std::abs(one.red - other.red), std::abs(one.green - other.green),
                   std::abs(one.blue - other.blue)});
}

Colour with(const Colour& base, int channel, int value) {
  Colour colour = base;
  (channel == 0   ? colour.red
   : channel == 1 ? colour.green
                  : colour.blue) = static_cast<std::uint8_t>(value);
  return colour;
}

// Shades that differ in one channel only, a few at a time: exact in every channel while half the
// places are free.
TEST(Palette, TellsShadesOfEveryChannelApart) {
  for (const int channel : {0, 1, 2}) {
    std::vector<Colour> shades;
    for (int value = 0; value < 256; value += 4)
      shades.push_back(with({90, 90, 90}, channel, value));
    Palette palette;
    const auto places = palette.places_of(row_of(shades));
    EXPECT_EQ(palette.taken(), static_cast<int>(shades.size())) << channel;
    for (std::size_t k = 0; k < shades.size(); ++k)
      EXPECT_EQ(farthest(palette.colours()[places[k]], shades[k]), 0) << channel << ' ' << k;
  }
}

TEST(Palette, TakesShadesWithinThreeLevelsTogetherInEveryChannel) {
  for (const int channel : {0, 1, 2}) {
    Palette palette;
    const auto places =
        palette.places_of(row_of({with({80, 80, 80}, channel, 80), with({80, 80, 80}, channel, 83),
                                  with({80, 80, 80}, channel, 84)}));
    EXPECT_EQ(places[0], places[1]);
    EXPECT_NE(places[0], places[2]);
  }
}

// With many colours, each is as near as the threshold of nearness once all places are taken.
TEST(Palette, IsNeverFartherThanItsLastStep) {
  std::vector<Colour> all;
  for (int r = 0; r < 256; r += 51)
    for (int g = 0; g < 256; g += 51)
      for (int b = 0; b < 256; b += 51)
        all.push_back({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                       static_cast<std::uint8_t>(b)});
  Palette palette;
  const auto places = palette.places_of(row_of(all));
  EXPECT_EQ(palette.taken(), static_cast<int>(all.size()));  // 216, all far apart
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ(farthest(palette.colours()[places[k]], all[k]), 0);
  EXPECT_EQ(std::ranges::count(places, Palette::transparent), 0);
}

TEST(Palette, KeepsItsColoursFromFrameToFrame) {
  Palette palette;
  const std::vector<Colour> first{{10, 20, 30}, {200, 100, 0}}, second{{1, 250, 3}, {10, 20, 30}};
  const auto one = palette.places_of(row_of(first));
  const auto other = palette.places_of(row_of(second));
  EXPECT_EQ(one[0], other[1]);
  EXPECT_EQ(palette.taken(), 3);
  EXPECT_EQ(palette.colours()[one[1]].red, 200);
  EXPECT_EQ(palette.colours()[one[1]].green, 100);
  EXPECT_EQ(palette.colours()[one[1]].blue, 0);
}

}  // namespace
}  // namespace hackle
