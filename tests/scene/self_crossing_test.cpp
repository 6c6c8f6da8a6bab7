// SPDX-License-Identifier: MIT
#include "scene/self_crossing.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

Polygon star_of(int points, int stride) {
  Polygon polygon;
  for (int k = 0; k < points; ++k) {
    const double angle = 2.0 * std::numbers::pi * k * stride / points;
    polygon.points.push_back({std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

TEST(SelfCrossing, IsFoundInABowTie) {
  const auto found = crossing_sides({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(*found, std::pair(std::size_t{0}, std::size_t{2}));
}

// A chain that goes once around has none, however many points it has; one that skips points has.
TEST(SelfCrossing, IsThatOfAChainThatGoesAroundTwice) {
  for (const int points : {5, 7, 101}) {
    EXPECT_FALSE(crossing_sides(star_of(points, 1)).has_value()) << points;
    EXPECT_TRUE(crossing_sides(star_of(points, 2)).has_value()) << points;
  }
}

// A ring with a bridge to its hole, a side that is gone back, a corner on a side, a point twice.
TEST(SelfCrossing, IsNotATouch) {
  EXPECT_FALSE(
      crossing_sides(
          {{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}})
          .has_value());
  EXPECT_FALSE(crossing_sides({{{0, 0}, {2, 0}, {2, 1}, {2, 0}, {2, 3}, {0, 3}}}).has_value());
  EXPECT_FALSE(crossing_sides({{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}}).has_value());
  EXPECT_FALSE(crossing_sides({{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}}}).has_value());
}

}  // namespace
}  // namespace hackle
