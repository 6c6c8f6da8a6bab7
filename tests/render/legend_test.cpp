// SPDX-License-Identifier: MIT
#include "render/legend.hpp"

#include <gtest/gtest.h>

#include "render/theme.hpp"
#include "support/pixels.hpp"

namespace hackle {
namespace {

// A scale of 2 px per mm: a round length of about a fifth of 900 px is 50 mm.
TEST(Legend, HasTheBarAndAScaleOfItsPictures) {
  PictureStyle style;
  style.grid = {10, 10, 1e-3, {0, 0}};
  Legend legend(style, 900, 2000.0);
  const Image image = legend.paint({});
  EXPECT_EQ(image.width, 900);
  EXPECT_GT(image.height, 20);
  EXPECT_LT(image.height, 90);
  const Colour line = theme_of(Background::dark).text;
  int longest = 0;
  for (int y = 0; y < image.height; ++y)
    longest = std::max(longest, test::count_pixels(image, {450, y, 450, 1}, [&](int x, int row) {
                         const auto* at = test::pixel(image, x, row);
                         return Colour{at[2], at[1], at[0]} == line;
                       }));
  EXPECT_NEAR(longest, 100, 2);
  EXPECT_NE(legend.paint({{false, true}}).pixels, image.pixels) << "the end is marked";
}

TEST(Legend, OfNothingHasNoHeight) {
  PictureStyle style;
  style.grid = {10, 10, 1e-3, {0, 0}};
  style.overlay.bar = style.overlay.scale_bar = false;
  EXPECT_EQ(Legend(style, 900, 2000.0).paint({}).height, 0);
}

}  // namespace
}  // namespace hackle
