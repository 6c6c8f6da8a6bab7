// SPDX-License-Identifier: MIT
#include "scene/star.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr double pi = std::numbers::pi;

// The shoelace formula, about the first corner.
double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 0; k + 1 < polygon.points.size(); ++k) {
    const Vec2 a = polygon.points[k] - polygon.points[0],
               b = polygon.points[k + 1] - polygon.points[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

// n triangles with the angle 2 pi/n between two sides of length radius.
TEST(Star, ARegularPolygonHasItsArea) {
  for (const int n : {3, 4, 5, 6, 17, 1000}) {
    const double wanted = 0.5 * n * 9.0 * std::sin(2.0 * pi / n);
    EXPECT_NEAR(area_of(star({2.0, -1.0}, 3.0, n, 0.3)), wanted, 1e-12 * wanted) << n;
  }
}

// 2n triangles with the angle pi/n between the two radii.
TEST(Star, AStarHasItsArea) {
  for (const int n : {3, 4, 5, 12}) {
    const double wanted = n * 3.0 * 1.2 * std::sin(pi / n);
    EXPECT_NEAR(area_of(star({2.0, -1.0}, 3.0, n, 0.3, 1.2)), wanted, 1e-12 * wanted) << n;
  }
}

TEST(Star, ItsCornersLieOnTwoCirclesAtEvenAngles) {
  const Vec2 centre(2.0, -1.0);
  const Polygon five = star(centre, 3.0, 5, 0.3, 1.2);
  ASSERT_EQ(five.points.size(), 10U);
  for (int k = 0; k < 10; ++k) {
    const double r = k % 2 == 0 ? 3.0 : 1.2, turn = 0.3 + pi * k / 5.0;
    const Vec2 wanted = centre + r * Vec2(std::cos(turn), std::sin(turn));
    EXPECT_NEAR((five.points[static_cast<std::size_t>(k)] - wanted).norm(), 0.0, 1e-14) << k;
  }
}

TEST(Star, ASquareIsARectangle) {
  const Box box = bounds(star({0.0, 0.0}, std::sqrt(2.0), 4, pi / 4.0));
  EXPECT_NEAR((box.min - Vec2(-1, -1)).norm() + (box.max - Vec2(1, 1)).norm(), 0.0, 1e-15);
}

TEST(Star, ItIsItsOwnMirrorImageToTheBit) {
  for (const int n : {3, 5, 8, 11}) {
    const Polygon polygon = star({0.5, 0.0}, 3.0, n, 0.0, 1.1);
    const std::size_t count = polygon.points.size();
    for (std::size_t k = 1; k < count; ++k) {
      if (2 * k == count) continue;  // on the axis, up to the rounding of sin(pi)
      EXPECT_EQ(polygon.points[k].x(), polygon.points[count - k].x()) << n << ", " << k;
      EXPECT_EQ(polygon.points[k].y(), -polygon.points[count - k].y()) << n << ", " << k;
    }
  }
}

// Notches between the corners are outside: half way from the centre to the circumscribed circle.
TEST(Star, WhatLiesBetweenItsArmsIsOutside) {
  const Shape cross = star({0.0, 0.0}, 1.0, 4, 0.0, 0.2);
  for (int k = 0; k < 8; ++k) {
    const double turn = pi * k / 4.0;
    EXPECT_EQ(covers(cross, 0.5 * Vec2(std::cos(turn), std::sin(turn)), 1e-9), k % 2 == 0) << k;
  }
  EXPECT_TRUE(is_inside(cross, {0, 0}, 1e-9));
}

}  // namespace
}  // namespace hackle
