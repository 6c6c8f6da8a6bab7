// SPDX-License-Identifier: MIT
#include "render/overlay/strip_chart.hpp"

#include <map>
#include <string>

#include <gmock/gmock.h>

#include "support/pixels.hpp"

namespace hackle {
namespace {

using testing::Contains;
using testing::Field;

constexpr Rectangle room{10, 10, 400, 120};

class Strip : public testing::Test {
 protected:
  // Draws the chart on black.
  Image draw(const Chart& chart, double now) {
    Image image(420, 140);
    const StripChart strip(room, chart, now, layout, theme, font);
    Canvas canvas(image);
    strip.draw(canvas);
    texts = strip.texts();
    return image;
  }

  Font font;
  const Theme& theme = theme_of(Background::dark);
  Layout layout = make_layout({200, 80, 1e-3, {0, 0}}, 640);
  std::vector<PlacedText> texts;
};

// Returns the lowest row of a column with this colour; -1 for none.
int lowest(const Image& image, int x, Colour colour) {
  for (int y = image.height - 1; y >= 0; --y)
    if (test::differing(image, {x, y, 1, 1}, colour) == 0) return y;
  return -1;
}

TEST_F(Strip, ARampRisesAndThenIsLevel) {
  const Chart ramp{
      "load", "Pa", 1e-5, {{"traction", "", {{0.0, 0.0}, {5e-6, 12e6}, {1e-5, 12e6}}}}};
  const Image image = draw(ramp, 0.0);
  std::vector<int> tops;
  for (const int x : {150, 200, 290, 330}) {
    int top = -1;
    for (int y = 140 - 1; y >= 0; --y) {
      const auto* at = test::pixel(image, x, y);
      if (at[0] > at[2] + 60) top = y;  // the blue of the first curve
    }
    ASSERT_GE(top, 0) << x;
    tops.push_back(top);
  }
  EXPECT_LT(tops[1], tops[0] - 5);
  EXPECT_LT(tops[2], tops[1] - 5);
  EXPECT_EQ(tops[3], tops[2]);
}

TEST_F(Strip, SaysWhatItShowsInUnitsThatSuit) {
  draw({"load", "Pa", 3e-5, {{"traction", "", {{0.0, 0.0}, {3e-5, 12e6}}}}}, 1e-5);
  EXPECT_THAT(texts, Contains(Field(&PlacedText::text, "load (MPa)")));
  EXPECT_THAT(texts, Contains(Field(&PlacedText::text, "traction")));
  EXPECT_THAT(texts, Contains(Field(&PlacedText::text, "15")));
  EXPECT_THAT(texts, Contains(Field(&PlacedText::text, "30 µs")));
  draw({"energy", "J/m", 1e-3, {{"kinetic", "", {{0.0, 2500.0}}}}}, 0.0);
  EXPECT_THAT(texts, Contains(Field(&PlacedText::text, "energy (kJ/m)")));
}

// Distances of numbers beside the frame are proportional to their values, with the lines at the
// same heights.
TEST_F(Strip, HasItsNumbersWhereTheirValuesAre) {
  const Chart chart{"energy", "J/m", 2e-5, {{"kinetic", "", {{0.0, -10.0}, {2e-5, 20.0}}}}};
  draw(chart, 2e-5);
  std::map<std::string, double> y;
  for (const PlacedText& text : texts)
    if (!y.contains(text.text)) y[text.text] = text.y;  // times come after values
  ASSERT_TRUE(y.contains("−10") && y.contains("0") && y.contains("10") && y.contains("20"));
  EXPECT_NEAR(y["−10"] - y["10"], 2.0 * (y["10"] - y["20"]), 2.0);
  EXPECT_GT(y["−10"], y["20"] + 20.0);
}

// The line of the present moves to the right with time.
TEST_F(Strip, MarksThePresentMoment) {
  const Chart flat{"load factor", "", 1e-5, {}};
  int last = 0;
  for (const double now : {0.0, 2.5e-6, 1e-5}) {
    const Image image = draw(flat, now);
    int x = 0;
    for (int k = 0; k < 420; ++k)
      if (test::differing(image, {k, 60, 1, 1}, theme.quiet) == 0 &&
          lowest(image, k, theme.quiet) > 80)
        x = k;
    EXPECT_GT(x, last) << now;
    last = x;
  }
}

TEST_F(Strip, StaysInItsRoom) {
  const Chart wild{"energy", "J/m", 1e-5, {{"a", "", {{0.0, -1e9}, {2e-5, 1e9}}}, {"b", "", {}}}};
  const Image image = draw(wild, 3e-5);
  EXPECT_EQ(test::differing_outside(image, Image(420, 140), room), 0);
}

}  // namespace
}  // namespace hackle
