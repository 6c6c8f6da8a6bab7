// SPDX-License-Identifier: MIT
#include "render/theme.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hackle {
namespace {

// Relative luminance and contrast as defined by WCAG 2.1.
double luminance(Colour colour) {
  const auto linear = [](int part) {
    const double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}
double contrast(Colour a, Colour b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

// WCAG requires 4.5 for text.
TEST(Theme, EverythingThatIsWrittenCanBeRead) {
  for (const Background background : {Background::dark, Background::light}) {
    const Theme& theme = theme_of(background);
    EXPECT_GT(contrast(theme.text, theme.background), 7.0);
    EXPECT_GT(contrast(theme.quiet, theme.background), 4.5);
    for (const Colour curve : theme.curves) EXPECT_GT(contrast(curve, theme.background), 4.5);
  }
}

TEST(Theme, ATransparentGroundIsMadeForPaper) {
  const Theme &transparent = theme_of(Background::transparent),
              &light = theme_of(Background::light);
  EXPECT_EQ(transparent.opacity, 0.0);
  EXPECT_EQ(light.opacity, 1.0);
  EXPECT_TRUE(transparent.text == light.text);
}

// Cracks as gaps are seen on the least and the largest value of a field, and are open on a dark
// ground and on none.
TEST(Theme, GapsAreSeenOnALightPlate) {
  const Theme& light = theme_of(ground_of(Look::light));
  for (const std::string_view usual : {"damage", "inferno", "viridis", "vik"}) {
    const ColourMap map = load_colour_map(std::string(colours_for(Look::light, usual)));
    EXPECT_GT(contrast(light.gap, map.colours[usual == "vik" ? 128 : 0]), 7.0) << usual;
  }
  EXPECT_TRUE(theme_of(Background::dark).gap == background_colour);
}

TEST(Theme, ALightPlateIsNearlyWhiteWhereValuesAreLeast) {
  for (const std::string_view usual : {"damage", "inferno", "viridis"}) {
    const auto colours = load_colour_map(std::string(colours_for(Look::light, usual))).colours;
    const Colour least = colours.front();
    EXPECT_GE(std::min({least.red, least.green, least.blue}), 235) << usual;
    EXPECT_GT(contrast(least, colours.back()), 10.0) << usual;
    EXPECT_EQ(colours_for(Look::dark, usual), usual);
  }
  EXPECT_EQ(colours_for(Look::light, "vik"), "vik");
}

TEST(Theme, EveryBackgroundHasItsName) {
  EXPECT_EQ(name_of(Background::dark), "dark");
  EXPECT_EQ(name_of(Background::light), "light");
  EXPECT_EQ(name_of(Background::transparent), "transparent");
}

}  // namespace
}  // namespace hackle
