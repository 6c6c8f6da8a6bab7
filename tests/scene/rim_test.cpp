// SPDX-License-Identifier: MIT
#include "scene/rim.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

double length_along(const Shape& shape) {
  double sum = 0.0;
  for (const Chain& chain : rims_of(shape))
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) sum += (chain[k + 1] - chain[k]).norm();
  return sum;
}

constexpr double half_turn = std::numbers::pi;

TEST(Rims, HaveTheLengthOfTheirShape) {
  EXPECT_NEAR(length_along(Ellipse{{1, 2}, {3, 3}, 0.4}), 6.0 * half_turn, 1e-5);
  // Half axes 2 and 1: 4 a E(e), e^2 = 3/4; Abramowitz and Stegun, table 17.2.
  EXPECT_NEAR(length_along(Ellipse{{1, 2}, {2, 1}, 0.4}), 8.0 * 1.21105602757, 1e-5);
  EXPECT_NEAR(length_along(Polygon{{{0, 0}, {3, 0}, {3, 4}}}), 12.0, 1e-12);
  EXPECT_NEAR(length_along(Capsule{{{0, 0}, {3, 4}}, 2.0}), 10.0 + 4.0 * half_turn, 1e-5);
  EXPECT_NEAR(length_along(Ring{{0, 0}, 3.0, 1.0}), 8.0 * half_turn, 1e-5);
  EXPECT_NEAR(length_along(Bitmap{{0, 0}, {3, 2}, 3, 2, {1, 1, 0, 0, 1, 0}}), 8.0, 1e-12);
}

TEST(Rims, LieOnTheirShapes) {
  for (const Shape& shape :
       {Shape(Ellipse{{1, 2}, {3, 1}, 0.4}), Shape(Capsule{{{0, 0}, {3, 4}}, 2.0}),
        Shape(Ring{{0, 0}, 3.0, 1.0}), Shape(Bitmap{{0, 0}, {3, 2}, 3, 2, {1, 1, 0, 0, 1, 0}})})
    for (const Chain& chain : rims_of(shape))
      for (const Vec2& point : chain) {
        EXPECT_TRUE(covers(shape, point, 1e-9)) << kind_of(shape);
        EXPECT_FALSE(is_inside(shape, point, 1e-9)) << kind_of(shape);
      }
}

// A square seen from its middle: 90 degrees are a side, wherever they begin.
TEST(Rims, AreCutAtTheirAngles) {
  const Chain square = rims_of(rectangle({-1, -1}, {1, 1})).front();
  for (const double from : {-0.25 * half_turn, 0.25 * half_turn, 1.75 * half_turn}) {
    double sum = 0.0;
    for_each_between(square, {0, 0}, Vec2(from, from + 0.5 * half_turn),
                     [&](const Segment& part) { sum += (part.to - part.from).norm(); });
    EXPECT_NEAR(sum, 2.0, 1e-9) << from;
  }
  const auto parts = parts_between({{1, -1}, {1, 1}}, {0, 0}, Vec2(std::atan(0.5), -0.1));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].from.y(), -std::tan(0.1), 1e-12);
  EXPECT_NEAR(parts[0].to.y(), 0.5, 1e-12);
}

}  // namespace
}  // namespace hackle
