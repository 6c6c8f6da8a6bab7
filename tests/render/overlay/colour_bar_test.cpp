// SPDX-License-Identifier: MIT
#include "render/overlay/colour_bar.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "support/pixels.hpp"

namespace hackle {
namespace {

class Bar : public testing::Test {
 protected:
  // Returns the centre of each number, px from the left end of the colours, over their length.
  std::map<std::string, double> numbers(const BarText& text) {
    OverlayText all;
    all.bars = {text};
    const Layout layout = make_layout({200, 80, 1e-3, {0, 0}}, 1280, all);
    const BarRoom& room = layout.bars.at(0);
    const ColourBar bar(layout, room, text, theme_of(Background::dark), font);
    std::map<std::string, double> places;
    for (const PlacedText& number : bar.texts())
      places[number.text] =
          (number.x + 0.5 * font.width_of(number.text, number.size) - room.colours.x) /
          (room.colours.width - 1);
    width = room.colours.width;
    return places;
  }

  // To two pixels: texts and marks lie on whole pixels.
  void expect_at(const std::map<std::string, double>& places, const std::string& number,
                 double share) {
    ASSERT_TRUE(places.contains(number)) << number;
    EXPECT_NEAR(places.at(number), share, 2.0 / width) << number;
  }

  Font font;
  int width = 0;
};

TEST_F(Bar, HasItsNumbersWhereTheirColoursAre) {
  const auto places = numbers({"stress", -10.0, 30.0, false});
  expect_at(places, "0", 0.25);
  expect_at(places, "10", 0.5);
  expect_at(places, "20", 0.75);
  EXPECT_TRUE(places.contains("stress"));
}

TEST_F(Bar, OfALogarithmHasItsDecadesEquallyFarApart) {
  const auto places = numbers({"energy", 1.0, 1e4, true});
  expect_at(places, "10", 0.25);
  expect_at(places, "100", 0.5);
  expect_at(places, "1000", 0.75);
}

TEST_F(Bar, OfWholeNumbersHasNoOthers) {
  const auto few = numbers({"fringes", 0.0, 2.3, false, true});
  EXPECT_EQ(few.size(), 4U);  // with the label
  expect_at(few, "0", 0.0);
  expect_at(few, "1", 1.0 / 2.3);
  expect_at(few, "2", 2.0 / 2.3);
  EXPECT_TRUE(numbers({"fringes", 0.0, 13.0, false, true}).contains("5"));
  EXPECT_TRUE(numbers({"fringes", 0.0, 2.3, false}).contains("0.5"));
}

TEST_F(Bar, HasARemarkBelowItsLabel) {
  const auto plain = numbers({"speed", 0.0, 1.0, false});
  const auto remarked = numbers({"speed", 0.0, 1.0, false, false, "× 5"});
  EXPECT_EQ(remarked.size(), plain.size() + 1);
  EXPECT_TRUE(remarked.contains("× 5"));
  EXPECT_LT(remarked.at("× 5"), 0.0);
}

// Counts the pixels of a colour left of the bar and right of it.
std::pair<int, int> ends_drawn(const Beyond& beyond) {
  OverlayText all;
  const Layout layout = make_layout({200, 80, 1e-3, {0, 0}}, 1280, all);
  const ColourBar bar(layout, layout.bars.at(0), all.bars[0], theme_of(Background::dark), Font());
  const ColourMap map{"two", {{200, 0, 0}, {0, 0, 200}}};
  Image image(layout.width, layout.height);
  {
    Canvas canvas(image);
    bar.draw_ends(canvas, map, beyond);
  }
  const Rectangle& seen = layout.bars[0].colours;
  const auto count = [&](const Rectangle& area, Colour colour) {
    return area.width * area.height - test::differing(image, area, colour);
  };
  return {count({0, 0, seen.x, layout.height}, map.colours.front()),
          count({seen.right(), 0, layout.width - seen.right(), layout.height}, map.colours.back())};
}

// A triangle of 0.7 times the height of the bar, in the colour of its end, less its rim.
TEST(BarEnds, AreMarkedWhereValuesLieBeyond) {
  EXPECT_EQ(ends_drawn({}), std::pair(0, 0));
  OverlayText all;
  const double height = make_layout({200, 80, 1e-3, {0, 0}}, 1280, all).bars.at(0).colours.height;
  const double area = 0.5 * 0.7 * height * height, rim = 2.5 * height;
  const auto below = ends_drawn({true, false}), above = ends_drawn({false, true});
  EXPECT_NEAR(below.first, area, rim);
  EXPECT_GT(below.first, 0.3 * area);
  EXPECT_EQ(below.second, 0);
  EXPECT_EQ(above.first, 0);
  EXPECT_GT(above.second, 0.3 * area);
}

TEST_F(Bar, GoesThroughItsColoursFromTheLeft) {
  OverlayText all;
  const Layout layout = make_layout({200, 80, 1e-3, {0, 0}}, 640, all);
  const ColourBar bar(layout, layout.bars.at(0), all.bars[0], theme_of(Background::dark), font);
  ColourMap map{"ramp", std::vector<Colour>(256)};
  for (std::size_t k = 0; k < 256; ++k)
    map.colours[k] = {static_cast<std::uint8_t>(k), 7, static_cast<std::uint8_t>(255 - k)};
  Image image(layout.width, layout.height);
  Canvas canvas(image);
  bar.draw(canvas, map);
  const Rectangle& seen = layout.bars[0].colours;
  for (int x = 0; x < seen.width; ++x) {
    const auto* pixel = test::pixel(image, seen.x + x, seen.y + seen.height / 2);
    EXPECT_NEAR(pixel[2], 255.0 * x / (seen.width - 1), 1.0) << x;
    EXPECT_EQ(pixel[1], 7);
    EXPECT_EQ(pixel[0], 255 - pixel[2]);
  }
}

}  // namespace
}  // namespace hackle
