// SPDX-License-Identifier: MIT
#include "render/overlay/markers.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

// 100 x 40 mm.
const Grid fine_grid{200, 80, 0.5e-3, {0.05, 0.02}};

class Markers : public testing::Test {
 protected:
  std::vector<PlacedMarker> place(const std::vector<Marker>& markers) {
    return place_markers(markers, layout, layout.plate,
                         Camera(fine_grid, {0, 0, 200, 80}, 0.0, layout.plate), font);
  }
  Vec2 pixel(double x, double y) const {
    return {layout.plate.x + layout.plate.width * x / 0.1,
            layout.plate.bottom() - layout.plate.height * y / 0.04};
  }
  double right_of(const PlacedText& text) const {
    return text.x + font.width_of(text.text, text.size);
  }

  Font font;
  Layout layout = make_layout(fine_grid, 1280);
};

TEST_F(Markers, StandAtTheirPlaces) {
  const auto placed = place({{{0.01, 0.03}, "a"}, {{0.08, 0.005}, "b"}});
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_NEAR((placed[0].place - pixel(0.01, 0.03)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((placed[1].place - pixel(0.08, 0.005)).norm(), 0.0, 1e-9);
  EXPECT_EQ(placed[0].label->text, "a");
  EXPECT_EQ(placed[1].label->text, "b");
}

TEST_F(Markers, AreLeftOutBeyondEverySideOfThePlate) {
  EXPECT_EQ(place({{{0.0, 0.0}, "a"}, {{0.1, 0.04}, "b"}}).size(), 2U);
  for (const Vec2& off :
       {Vec2(-0.001, 0.02), Vec2(0.101, 0.02), Vec2(0.05, -0.001), Vec2(0.05, 0.041)})
    EXPECT_TRUE(place({{off, "off"}}).empty()) << off.transpose();
}

// Right of the point if there is room, left of it at the right edge of the picture.
TEST_F(Markers, HaveTheirLabelsBesideThem) {
  const auto placed = place({{{0.05, 0.02}, "middle"}, {{0.1, 0.03}, "a long name at the edge"}});
  EXPECT_GT(placed[0].label->x, placed[0].place.x());
  EXPECT_NEAR(placed[0].label->y, placed[0].place.y(), layout.small_font);
  EXPECT_LT(right_of(*placed[1].label), placed[1].place.x());
}

TEST_F(Markers, NeverCoverEachOther) {
  std::vector<Marker> markers;
  for (int k = 0; k < 12; ++k) markers.push_back({{0.05 + 1e-5 * k, 0.02}, "number"});
  const auto placed = place(markers);
  ASSERT_EQ(placed.size(), 12U);
  int shown = 0;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (!placed[k].label) continue;
    ++shown;
    for (std::size_t other = 0; other < k; ++other) {
      if (!placed[other].label) continue;
      const PlacedText &one = *placed[k].label, &two = *placed[other].label;
      const bool apart = right_of(one) <= two.x || right_of(two) <= one.x ||
                         std::abs(one.y - two.y) >= 0.8 * one.size;
      EXPECT_TRUE(apart) << k << ' ' << other;
    }
  }
  EXPECT_GE(shown, 2);
  EXPECT_LT(shown, 12);
}

}  // namespace
}  // namespace hackle
