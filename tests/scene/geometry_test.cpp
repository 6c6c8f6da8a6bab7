// SPDX-License-Identifier: MIT
#include "scene/geometry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Geometry, SegmentsOnOneObliqueLineKeepTheirGap) {
  const Vec2 along = Vec2(3.0, 1.0) / 7.0;
  for (int k = 1; k < 200; ++k) {
    const Vec2 shift(0.1 * k, -0.3 * k);
    const Segment one{shift, shift + along}, other{shift + 3.0 * along, shift + 5.0 * along};
    EXPECT_NEAR(distance(one, other), 2.0 * along.norm(), 1e-12) << k;
  }
}

TEST(Geometry, CrossingSegmentsHaveNoDistance) {
  EXPECT_EQ(distance(Segment{{0, 0}, {2, 2}}, Segment{{0, 2}, {2, 0}}), 0.0);
  EXPECT_NEAR(distance(Segment{{0, 0}, {2, 0}}, Segment{{1, 0}, {1, 5}}), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(distance(Segment{{0, 0}, {2, 0}}, Segment{{1, 3}, {1, 5}}), 3.0);
}

TEST(Geometry, ChordsOfAnArcStayWithinAMillionthOfItsRadius) {
  const std::vector<Vec2> points = arc({1.0, 2.0}, 5.0, 0.3, 2.3);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vec2 middle = 0.5 * (points[k] + points[k + 1]) - Vec2(1.0, 2.0);
    EXPECT_NEAR(middle.norm(), 5.0, 5e-6);
    EXPECT_NEAR((points[k] - Vec2(1.0, 2.0)).norm(), 5.0, 1e-14);
  }
  EXPECT_NEAR((points.back() - Vec2(1.0 + 5.0 * std::cos(2.3), 2.0 + 5.0 * std::sin(2.3))).norm(),
              0.0, 1e-14);
}

TEST(Geometry, AWholeTurnEndsWhereItBegan) {
  const std::vector<Vec2> points = arc({0, 0}, 1.0, 0.1, 0.1 + 2.0 * std::numbers::pi);
  EXPECT_EQ(points.front(), points.back());
}

// Anticlockwise for ascending angles, clockwise for descending ones.
TEST(Geometry, AnArcGoesTheWayItsAnglesSay) {
  for (const double from : {-4.0, -0.5, 1.0, 3.0})
    for (const double turn : {-3.0, -1.0, 0.5, 2.0, 5.0}) {
      const std::vector<Vec2> points = arc({1.0, 2.0}, 3.0, from, from + turn);
      const auto at = [](double angle) {
        return Vec2(1.0 + 3.0 * std::cos(angle), 2.0 + 3.0 * std::sin(angle));
      };
      EXPECT_NEAR((points.front() - at(from)).norm(), 0.0, 1e-12);
      EXPECT_NEAR((points.back() - at(from + turn)).norm(), 0.0, 1e-12);
      const std::size_t quarter = (points.size() - 1) / 4;
      const double share = static_cast<double>(quarter) / static_cast<double>(points.size() - 1);
      EXPECT_NEAR((points[quarter] - at(from + share * turn)).norm(), 0.0, 1e-12) << from << turn;
    }
}

}  // namespace
}  // namespace hackle
