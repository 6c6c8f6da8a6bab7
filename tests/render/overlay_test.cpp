// SPDX-License-Identifier: MIT
#include "render/overlay.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

// Pixels of a rectangle that are not black.
int lit(const Image& image, const Rectangle& area) {
  int count = 0;
  for (int y = area.y; y < area.bottom(); ++y)
    for (int x = area.x; x < area.right(); ++x) {
      const auto* pixel = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
      count += pixel[0] + pixel[1] + pixel[2] > 0 ? 1 : 0;
    }
  return count;
}

class Overlay : public testing::TestWithParam<int> {
 protected:
  Layout layout = make_layout({200, 80, 0.5e-3, {0.05, 0.02}}, GetParam());
  Image image{layout.width, layout.height};
  OverlayText text{"", "damage", 0.0, 0.5, false, 0.1 / layout.plate.width};
};

TEST_P(Overlay, DrawsBarScaleAndTimeWhereTheyBelong) {
  draw_frame(image, layout, load_colour_map("damage"), text);
  EXPECT_EQ(lit(image, layout.bar), layout.bar.width * layout.bar.height);
  EXPECT_GT(lit(image, layout.scale), 0);
  EXPECT_EQ(lit(image, layout.plate), 0) << "the plate is not painted over";
  EXPECT_EQ(lit(image, layout.caption), 0);
  draw_time(image, layout, 22.5e-6);
  EXPECT_GT(lit(image, layout.caption), 0);
}

// Pixels of the row right below the bar that are lit, one a tick.
int tick_count(const Image& image, const Layout& layout) {
  return lit(image, {layout.bar.x, layout.bar.bottom(), layout.bar.width, 1});
}

TEST_P(Overlay, TicksAreNeatWhateverTheRange) {
  struct Case {
    double least, most;
    bool logarithmic;
    int fewest, most_ticks;
  };
  for (const Case& c : {Case{0.0, 0.5, false, 2, 6},
                        {-65.0, 65.0, false, 2, 6},
                        {0.123, 0.789, false, 1, 6},
                        {13.0, 1.3e5, true, 4, 4},
                        {1.0, 1e4, true, 5, 5}}) {
    Image fresh{layout.width, layout.height};
    text.least = c.least;
    text.most = c.most;
    text.logarithmic = c.logarithmic;
    draw_frame(fresh, layout, load_colour_map("damage"), text);
    EXPECT_GE(tick_count(fresh, layout), c.fewest) << c.least << " " << c.most;
    EXPECT_LE(tick_count(fresh, layout), c.most_ticks) << c.least << " " << c.most;
  }
}

TEST_P(Overlay, DrawsDiscsWhereTheyAreAndNowhereElse) {
  const Grid grid{200, 80, 0.5e-3, {0.05, 0.02}};
  draw_discs(image, layout, grid, {});
  const Rectangle all{0, 0, image.width, image.height};
  EXPECT_EQ(lit(image, all), 0);
  // A tenth of the plate's width across, in its middle: pi/4 of the square around it, and its rim.
  draw_discs(image, layout, grid, {{{0.05, 0.02}, 0.005}});
  const double width = 0.1 * layout.plate.width, area = 0.25 * std::numbers::pi * width * width;
  EXPECT_NEAR(lit(image, all), area, 2.0 * std::numbers::pi * width);
  const int x = layout.plate.x + layout.plate.width / 2,
            y = layout.plate.y + layout.plate.height / 2, r = static_cast<int>(0.5 * width) + 2;
  EXPECT_EQ(lit(image, {x - r, y - r, 2 * r, 2 * r}), lit(image, all));
  // Neither the caption nor the legend are painted over, however large it is.
  draw_discs(image, layout, grid, {{{-0.5, -0.5}, 10.0}});
  EXPECT_EQ(lit(image, layout.caption), 0);
  EXPECT_EQ(lit(image, layout.bar), 0);
}

TEST_P(Overlay, StaysInsideThePicture) {
  text.title = "A title";
  draw_frame(image, layout, load_colour_map("damage"), text);
  draw_time(image, layout, 1e-4);
  const int w = layout.width, h = layout.height;
  EXPECT_EQ(lit(image, {0, 0, w, 1}) + lit(image, {0, h - 1, w, 1}), 0);
  EXPECT_EQ(lit(image, {0, 0, 1, h}) + lit(image, {w - 1, 0, 1, h}), 0);
}

INSTANTIATE_TEST_SUITE_P(Widths, Overlay, testing::Values(320, 640, 1280, 3840));

TEST(TimeText, HasTwoDecimalsSoThatItDoesNotDance) {
  EXPECT_EQ(time_text(0.0), "0.00 µs");
  EXPECT_EQ(time_text(22.5e-6), "22.50 µs");
  EXPECT_EQ(time_text(1.25e-3), "1.2500 ms");
}

}  // namespace
}  // namespace hackle
