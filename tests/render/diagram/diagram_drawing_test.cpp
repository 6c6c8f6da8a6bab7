// SPDX-License-Identifier: MIT
#include "render/diagram/diagram_drawing.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "support/pixels.hpp"

namespace hackle {
namespace {

using testing::Contains;
using testing::Field;
using testing::Not;

class Drawn : public testing::Test {
 protected:
  void draw(const Diagram& diagram) {
    image = Image(size.width, size.height);
    const DiagramDrawing drawing(diagram, size, theme, font);
    Canvas canvas(image);
    drawing.draw(canvas);
    canvas.finish();
    texts = drawing.texts();
    frame = drawing.frame();
  }

  // Returns whether a px there, or the one above or below it, has the colour of that curve, up to
  // its smooth edge.
  bool has(const Vec2& share, std::size_t curve = 0) const {
    const int x = static_cast<int>(std::lround(frame.x + share.x() * frame.width));
    const int y = static_cast<int>(std::lround(frame.bottom() - share.y() * frame.height));
    const Colour& wanted = theme.curves[curve];
    constexpr int near = 80;
    for (int row = y - 1; row <= y + 1; ++row) {
      const auto* at = test::pixel(image, x, row);
      if (std::abs(at[0] - wanted.blue) < near && std::abs(at[1] - wanted.green) < near &&
          std::abs(at[2] - wanted.red) < near)
        return true;
    }
    return false;
  }

  const DiagramSize size{600, 400, 12.0};
  const Theme& theme = theme_of(Background::light);
  Font font;
  Image image;
  std::vector<PlacedText> texts;
  Rectangle frame;
};

DiagramCurve straight(double slope, int points = 100) {
  DiagramCurve curve{"straight", {}};
  for (int k = 0; k <= points; ++k)
    curve.points.emplace_back(10.0 * k / points, slope * k / points);
  return curve;
}

TEST_F(Drawn, ALineIsWhereItsValuesAre) {
  draw({"a title", {"time", "s", Ends{0, 10}}, {"way", "m", Ends{0, 20}}, {straight(10.0)}, {}});
  for (const double along : {0.1, 0.35, 0.7, 0.95}) {
    EXPECT_TRUE(has({along, 0.5 * along})) << along;
    EXPECT_FALSE(has({along, 0.5 * along + 0.1})) << along;
  }
  for (const char* text : {"a title", "straight", "time (s)", "way (m)"})
    EXPECT_THAT(texts, Contains(Field(&PlacedText::text, text)));
}

TEST_F(Drawn, NothingLeavesItsFrame) {
  draw({"", {"time", "s", Ends{0, 10}}, {"way", "m", Ends{0, 5}}, {straight(1000.0)}, {}});
  const Rectangle above{frame.x, 0, frame.width, frame.y - 1};
  for (int y = above.y; y < above.bottom(); ++y)
    for (int x = above.x + 60; x < above.right(); ++x) {  // right of the heading
      const auto* at = test::pixel(image, x, y);
      ASSERT_EQ(at[0], theme.background.blue) << x << ", " << y;
    }
}

TEST_F(Drawn, ANumberThatIsNotThereInterrupts) {
  DiagramCurve curve = straight(10.0);
  for (std::size_t k = 40; k < 60; ++k)
    curve.points[k].y() = std::numeric_limits<double>::quiet_NaN();
  draw({"", {"x", "", Ends{0, 10}}, {"y", "", Ends{0, 10}}, {curve}, {}});
  EXPECT_TRUE(has({0.3, 0.3}));
  EXPECT_FALSE(has({0.5, 0.5}));
  EXPECT_TRUE(has({0.7, 0.7}));
}

TEST_F(Drawn, BarsStandOnZero) {
  const DiagramCurve bars{"", {{1, 2}, {2, 0}, {3, 4}}, DiagramStroke::bars};
  draw({"", {"x", "", Ends{0.5, 3.5}}, {"y", "", Ends{0, 4}}, {bars}, {}});
  EXPECT_TRUE(has({1.0 / 6.0, 0.25}));
  EXPECT_FALSE(has({1.0 / 6.0, 0.75}));
  EXPECT_FALSE(has({0.5, 0.1}));
  EXPECT_TRUE(has({5.0 / 6.0, 0.9}));
}

TEST_F(Drawn, LevelsAreNamed) {
  draw({"", {"x", ""}, {"speed", "m/s", Ends{0, 4000}}, {straight(100.0)}, {{"c_R", 3000.0}}});
  EXPECT_THAT(texts, Contains(Field(&PlacedText::text, "c_R")));
  draw({"", {"x", ""}, {"speed", "m/s", Ends{0, 1000}}, {straight(100.0)}, {{"c_R", 3000.0}}});
  EXPECT_THAT(texts, Not(Contains(Field(&PlacedText::text, "c_R"))));
}

TEST_F(Drawn, AMarkStandsBesideTheLastPoint) {
  DiagramCurve curve = straight(10.0);
  curve.points.resize(51);  // ends in the middle
  curve.mark = "7";
  draw({"", {"x", "", Ends{0, 10}}, {"y", "", Ends{0, 10}}, {curve}, {}});
  const auto mark = std::ranges::find(texts, "7", &PlacedText::text);
  ASSERT_NE(mark, texts.end());
  EXPECT_NEAR(mark->x, frame.x + 0.5 * frame.width, size.font);
  EXPECT_NEAR(mark->y, frame.y + 0.5 * frame.height, size.font);
  curve.mark = "far";
  draw({"", {"x", "", Ends{0, 4}}, {"y", "", Ends{0, 10}}, {curve}, {}});
  EXPECT_THAT(texts, Not(Contains(Field(&PlacedText::text, "far"))));
}

TEST_F(Drawn, AMapIsToScale) {
  Diagram map{"", {"x", "m"}, {"y", "m"}, {straight(4.0)}, {}};
  map.to_scale = true;
  draw(map);
  EXPECT_NEAR(static_cast<double>(frame.width) / frame.height, 10.0 / 4.0, 0.02);
}

TEST_F(Drawn, ManyNamesFindRoomInRows) {
  Diagram many{"", {"x", ""}, {"y", ""}, {}, {}};
  for (int k = 0; k < 12; ++k) {
    many.curves.push_back(straight(k));
    many.curves.back().name = "a long name of a curve " + std::to_string(k);
  }
  draw(many);
  for (const PlacedText& text : texts)
    EXPECT_LE(text.x + font.width_of(text.text, text.size), size.width) << text.text;
  EXPECT_GT(frame.height, 100);
}

// A table of a million rows is thinned to what its px can show.
TEST_F(Drawn, ExtremesOfADenseCurveStay) {
  DiagramCurve dense{"", {}};
  for (int k = 0; k < 100000; ++k)
    dense.points.emplace_back(1e-4 * k, k == 50000 ? 9.0 : 1.0 + 0.1 * (k % 2));
  draw({"", {"x", "", Ends{0, 10}}, {"y", "", Ends{0, 10}}, {dense}, {}});
  EXPECT_TRUE(has({0.5, 0.8}));
  EXPECT_TRUE(has({0.25, 0.105}));
}

}  // namespace
}  // namespace hackle
