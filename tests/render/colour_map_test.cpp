// SPDX-License-Identifier: MIT
#include "render/colour_map.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace hackle {
namespace {

double linear(std::uint8_t value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Lightness of OKLab (Ottosson 2020), 0..1.
double lightness(Colour colour) {
  const double r = linear(colour.red), g = linear(colour.green), b = linear(colour.blue);
  return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
         0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
         0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

TEST(ColourMaps, AreAllComplete) {
  EXPECT_THAT(colour_map_names(), testing::Contains("damage"));
  for (const std::string& name : colour_map_names()) EXPECT_NO_THROW(load_colour_map(name)) << name;
}

TEST(DamageMap, RisesEvenlyInLightness) {
  const ColourMap map = load_colour_map("damage");
  const double first = lightness(map.colours.front()), last = lightness(map.colours.back());
  EXPECT_GT(last - first, 0.6);
  for (std::size_t k = 1; k < 256; ++k) {
    // Rounding to 8 bits moves the lightness by up to 0.004.
    const double even = first + (last - first) * static_cast<double>(k) / 255.0;
    EXPECT_NEAR(lightness(map.colours[k]), even, 0.006) << k;
  }
}

TEST(ColourMaps, AnUnknownNameGetsTheNearest) {
  try {
    load_colour_map("damge");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'damage'?"));
  }
}

}  // namespace
}  // namespace hackle
