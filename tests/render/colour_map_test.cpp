// SPDX-License-Identifier: MIT
#include "render/colour_map.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"

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
  for (const std::string_view name : colour_map_names)
    EXPECT_NO_THROW(load_colour_map(std::string(name))) << name;
}

TEST(ColourMaps, AreThoseOfTheFolder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(data_file("assets/colour_maps")))
    files.push_back(entry.path().stem().string());
  EXPECT_THAT(files, testing::UnorderedElementsAreArray(colour_map_names));
}

TEST(ColourMaps, SayWhereTheyComeFrom) {
  for (const std::string_view name : colour_map_names) {
    const std::string text = read_text(data_file(fmt::format("assets/colour_maps/{}.csv", name)));
    EXPECT_TRUE(text.find("licence") != std::string::npos || text.find("CC0") != std::string::npos)
        << name;
  }
}

// The two ends of a diverging map have equal lightness, which differs from that of the middle.
TEST(ColourMaps, ThoseForTwoSignsAreEvenOnBothSides) {
  for (const char* name : {"vik", "roma"}) {
    const std::vector<Colour> colours = load_colour_map(name).colours;
    EXPECT_NEAR(lightness(colours.front()), lightness(colours.back()), 0.12) << name;
    EXPECT_GT(lightness(colours[128]) - lightness(colours.front()), 0.3) << name;
  }
}

TEST(FringeMap, IsDarkAtWholeOrders) {
  const ColourMap map = fringe_map(0.0, 3.0);
  EXPECT_EQ(map.colours.front(), (Colour{0, 0, 0}));
  EXPECT_LE(map.colours.back().red, 1);
  const std::size_t half = (map.colours.size() - 1) / 6;
  EXPECT_GE(map.colours[half].red, 254);
}

TEST(OwnMaps, ChangeEvenlyInLightness) {
  for (const char* name : {"damage", "ember", "lagoon"}) {
    const ColourMap map = load_colour_map(name);
    const double first = lightness(map.colours.front()), last = lightness(map.colours.back());
    EXPECT_GT(std::abs(last - first), 0.6) << name;
    for (std::size_t k = 1; k < 256; ++k) {
      // Rounding to 8 bits moves the lightness by up to 0.004.
      const double even = first + (last - first) * static_cast<double>(k) / 255.0;
      EXPECT_NEAR(lightness(map.colours[k]), even, 0.006) << name << ' ' << k;
    }
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

// Dark at whole orders and light midway between them, wherever the range begins.
TEST(FringeMap, HasTheLightOfItsOrders) {
  for (const auto& [min, max] : {std::pair{0.0, 3.0}, {1.5, 4.0}, {-2.0, 0.5}, {7.25, 9.75}}) {
    const ColourMap map = fringe_map(min, max);
    const auto last = static_cast<double>(map.colours.size() - 1);
    for (std::size_t k = 0; k < map.colours.size(); ++k) {
      const double order = min + (max - min) * static_cast<double>(k) / last;
      const double light = std::pow(std::sin(std::numbers::pi * order), 2);
      EXPECT_NEAR(map.colours[k].red, 255.0 * std::pow(light, 1.0 / 2.2), 0.51) << order;
      EXPECT_EQ(map.colours[k].green, map.colours[k].red);
      EXPECT_EQ(map.colours[k].blue, map.colours[k].red);
    }
  }
}

}  // namespace
}  // namespace hackle
