// SPDX-License-Identifier: MIT
#include "render/overlay/axes.hpp"

#include <map>

#include <gtest/gtest.h>

#include "support/pixels.hpp"

namespace hackle {
namespace {

const Grid wide{200, 80, 0.5e-3, {0.05, 0.02}};  // 100 x 40 mm

OverlayText with_axes() {
  OverlayText text;
  text.parts.axes = true;
  return text;
}

class AxesAt : public testing::TestWithParam<int> {};

// Returns the middle of each number: along x by its own name, upwards after "y".
std::map<std::string, double> numbers(const Layout& layout, const Window& window) {
  const Font font;
  const Camera camera(wide, window, 0.0, layout.plate);
  const Axes axes(layout.plate, camera, layout, theme_of(Background::dark), font);
  std::map<std::string, double> found;
  for (const PlacedText& text : axes.texts())
    if (text.y > layout.plate.bottom() + 0.5 * text.size)
      found[text.text] = text.x + 0.5 * font.width_of(text.text, text.size);
    else
      found["y" + text.text] = text.y - 0.35 * text.size;
  return found;
}

TEST_P(AxesAt, NumbersStandWhereTheirPlacesAre) {
  const Layout layout = make_layout(wide, GetParam(), with_axes());
  const auto found = numbers(layout, {0, 0, 200, 80});
  ASSERT_TRUE(found.contains("0") && found.contains("50") && found.contains("y20"));
  const Rectangle& plate = layout.plate;
  EXPECT_NEAR(found.at("0"), plate.x, 1.5);
  EXPECT_NEAR(found.at("50"), plate.x + 0.5 * plate.width, 1.5);
  EXPECT_NEAR(found.at("y20"), plate.y + 0.5 * plate.height, 1.5);
  EXPECT_TRUE(found.contains("100 mm"));
}

TEST_P(AxesAt, LieInsideThePictureBesideThePlate) {
  const Layout layout = make_layout(wide, GetParam(), with_axes());
  const Camera camera(wide, {0, 0, 200, 80}, 0.0, layout.plate);
  const Font font;
  const Axes axes(layout.plate, camera, layout, theme_of(Background::dark), font);
  for (const PlacedText& text : axes.texts()) {
    EXPECT_GE(text.x, 0.0) << text.text;
    EXPECT_LE(text.x + font.width_of(text.text, text.size), layout.width) << text.text;
    EXPECT_LT(text.y, layout.foot) << text.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, AxesAt, testing::Values(640, 1280, 3840));

// A window from 60 to 80 mm.
TEST(Axes, OfAPartHaveItsCoordinates) {
  const Layout layout = make_layout(part(wide, {120, 20, 40, 16}), 1280, with_axes());
  const auto found = numbers(layout, {120, 20, 40, 16});
  ASSERT_TRUE(found.contains("70"));
  EXPECT_NEAR(found.at("70"), layout.plate.x + 0.5 * layout.plate.width, 1.5);
}

TEST(Camera, FindsThePlaceOfAPixel) {
  const Camera camera(wide, {20, 10, 100, 50}, 0.3, {10, 20, 800, 400});
  for (const Vec2& place : {Vec2(0.03, 0.01), Vec2(0.07, 0.035)})
    EXPECT_NEAR((camera.place(camera.pixel(place)) - place).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace hackle
