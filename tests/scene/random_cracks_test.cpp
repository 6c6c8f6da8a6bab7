// SPDX-License-Identifier: MIT
#include "scene/random_cracks.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

TEST(RandomCracks, AreTheSameForTheSameSeedAndLieInTheirArea) {
  RandomCracks cracks{.length = {1e-3, 5e-3},
                      .angle = {0.2, 0.4},
                      .area = {{0.01, 0.01}, {0.02, 0.03}},
                      .count = 200};
  const std::vector<Crack> one = make(cracks), again = make(cracks);
  cracks.seed = 2;
  EXPECT_NE(make(cracks).front().points, one.front().points);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].points, again[k].points);
    const Vec2 along = one[k].points[1] - one[k].points[0];
    EXPECT_TRUE(along.norm() > 0.999e-3 && along.norm() < 5.001e-3);
    const double angle = std::atan2(along.y(), along.x());
    EXPECT_TRUE(angle > 0.2 - 1e-12 && angle < 0.4 + 1e-12) << angle;
    for (const Vec2& p : one[k].points)
      EXPECT_TRUE(p.x() >= 0.01 - 1e-12 && p.x() <= 0.02 + 1e-12 && p.y() >= 0.01 - 1e-12 &&
                  p.y() <= 0.03 + 1e-12);
  }
}

TEST(RandomCracks, ThatDoNotFitAreRefused) {
  const RandomCracks cracks{.length = {1.0, 2.0}, .area = {{0, 0}, {0.1, 0.1}}, .count = 1};
  EXPECT_THROW(make(cracks), Error);
}

// Checks every octant, both senses of direction, and angles beyond a turn.
TEST(RandomCracks, PointWhereTheirAngleSays) {
  constexpr double pi = std::numbers::pi, spread = 0.05;
  for (double min = -9.0; min < 9.0; min += 0.31) {
    const RandomCracks cracks{.length = {1e-3, 2e-3},
                              .angle = {min, min + spread},
                              .area = {{0.0, 0.0}, {0.1, 0.04}},
                              .count = 20};
    for (const Crack& crack : make(cracks)) {
      const Vec2 along = crack.points[1] - crack.points[0];
      const double away =
          std::remainder(std::atan2(along.y(), along.x()) - min - 0.5 * spread, 2.0 * pi);
      EXPECT_LE(std::abs(away), 0.5 * spread + 1e-12) << min;
    }
  }
}

// Of 400 evenly distributed values, one lies within a twentieth of either end, except once in 1e8.
TEST(RandomCracks, TakeTheirWholeRangesAndBirth) {
  const RandomCracks cracks{.length = {2e-3, 4e-3},
                            .angle = {-0.1, 3.0},
                            .area = {{0.01, 0.005}, {0.09, 0.035}},
                            .count = 400,
                            .born = Born::absent};
  Vec2 lengths(1.0, 0.0), angles(9.0, -9.0), x(1.0, 0.0), y(1.0, 0.0);
  const auto widen = [](Vec2& range, double value) {
    range = {std::min(range.x(), value), std::max(range.y(), value)};
  };
  for (const Crack& crack : make(cracks)) {
    EXPECT_EQ(crack.born, Born::absent);
    const Vec2 along = crack.points[1] - crack.points[0];
    widen(lengths, along.norm());
    widen(angles, std::atan2(along.y(), along.x()));
    for (const Vec2& point : crack.points) {
      widen(x, point.x());
      widen(y, point.y());
    }
  }
  EXPECT_NEAR((lengths - Vec2(2e-3, 4e-3)).cwiseAbs().maxCoeff(), 0.0, 0.05 * 2e-3);
  EXPECT_NEAR((angles - Vec2(-0.1, 3.0)).cwiseAbs().maxCoeff(), 0.0, 0.05 * 3.1);
  EXPECT_NEAR((x - Vec2(0.01, 0.09)).cwiseAbs().maxCoeff(), 0.0, 0.05 * 0.08);
  EXPECT_NEAR((y - Vec2(0.005, 0.035)).cwiseAbs().maxCoeff(), 0.0, 0.05 * 0.03);
}

TEST(RandomCracks, RefuseRangesTheWrongWayRoundAndAreasOffThePlate) {
  const RandomCracks good{
      .length = {1e-3, 2e-3}, .angle = {0.0, 1.0}, .area = {{0.0, 0.0}, {0.1, 0.04}}, .count = 1};
  const auto problems = [&](auto change) {
    RandomCracks cracks = good;
    change(cracks);
    Problems found;
    check(test::bare_plate(200, 80), cracks, found);
    return found.list().size();
  };
  EXPECT_EQ(problems([](RandomCracks&) {}), 0U);
  EXPECT_EQ(problems([](RandomCracks& c) { c.length = {2e-3, 1e-3}; }), 1U);
  EXPECT_EQ(problems([](RandomCracks& c) { c.angle = {1.0, 0.0}; }), 1U);
  EXPECT_EQ(problems([](RandomCracks& c) { c.area.max = {0.0, 0.04}; }), 1U);
  for (const Vec2& off : {Vec2(0.101, 0.04), Vec2(0.1, 0.041)})
    EXPECT_EQ(problems([&](RandomCracks& c) { c.area.max = off; }), 1U);
  for (const Vec2& off : {Vec2(-0.001, 0.0), Vec2(0.0, -0.001)})
    EXPECT_EQ(problems([&](RandomCracks& c) { c.area.min = off; }), 1U);
}

}  // namespace
}  // namespace hackle
