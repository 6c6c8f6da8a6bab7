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

// Values beyond an end have its colour; only below 0 there is nothing.
TEST_F(Bar, SaysAtItsEndsWhatLiesBeyond) {
  const auto both = numbers({"stress", -10.0, 10.0, false});
  EXPECT_TRUE(both.contains("≤−10") && both.contains("≥10"));
  const auto damage = numbers({"damage", 0.0, 0.5, false});
  EXPECT_TRUE(damage.contains("0") && damage.contains("≥0.5"));
  for (const auto& [text, place] : both)
    EXPECT_TRUE(place < 0.1 || place > 0.9 ||
                (text.find("≤") == std::string::npos && text.find("≥") == std::string::npos))
        << text;
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
