// SPDX-License-Identifier: MIT
#include "scene/outline.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr double rim = 1e-9;  // points nearer lie on it

std::vector<Outline> some_outlines() {
  const Shape disc = Ellipse{{0, 0}, {2, 2}, 0}, turned = Ellipse{{0.5, 0}, {2.5, 0.7}, 0.6};
  const Shape l = Polygon{{{-2, -2}, {2, -2}, {2, -1}, {-1, -1}, {-1, 2}, {-2, 2}}};
  const Shape slot = Capsule{{{-2, -1}, {1, 2}}, 0.5}, ring = Ring{{0.2, 0.1}, 2.4, 1.1};
  const Shape cells = Bitmap{{-2, -2}, {2, 2}, 3, 3, {1, 0, 1, 1, 1, 1, 0, 1, 1}};
  return {{{disc}, ""},       {{turned}, ""},    {{l}, ""},
          {{slot}, ""},       {{ring}, ""},      {{cells}, ""},
          {{disc, slot}, ""}, {{l, turned}, ""}, {{ring, Ellipse{{0.2, 0.1}, {0.6, 0.6}, 0}}, ""}};
}

// Compares with 2000 points along the segment: a part between two of them is shorter than a sample.
TEST(Outline, ASegmentLeavesItWhenAnyOfItsPointsIsOutside) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  int stays = 0;
  for (const Outline& outline : some_outlines())
    for (int trial = 0; trial < 400; ++trial) {
      const Segment segment{{place(random), place(random)}, {place(random), place(random)}};
      bool outside = false;
      for (int k = 0; k <= 2000 && !outside; ++k)
        outside = !covers(outline, segment.from + (k / 2000.0) * (segment.to - segment.from), rim);
      stays += outside ? 0 : 1;
      if (outside) {
        EXPECT_TRUE(leaves(outline, segment, rim)) << trial;
      } else if (leaves(outline, segment, rim)) {
        EXPECT_FALSE(leaves(outline, segment, 0.005)) << trial;
      }
    }
  EXPECT_GT(stays, 300);
}

TEST(Outline, ASegmentAlongTheRimOrFromAreaToAreaStays) {
  const Outline square{{rectangle({0, 0}, {2, 2})}, ""};
  EXPECT_FALSE(leaves(square, {{0, 0}, {2, 0}}, rim));
  EXPECT_FALSE(leaves(square, {{0, 1}, {2, 2}}, rim));
  EXPECT_TRUE(leaves(square, {{0, 0}, {2.001, 0}}, rim));
  const Outline two{{rectangle({0, 0}, {2, 2}), rectangle({2, 0}, {4, 2})}, ""};
  EXPECT_FALSE(leaves(two, {{1, 1}, {3, 1}}, rim));
  const Outline apart{{rectangle({0, 0}, {2, 2}), rectangle({2.1, 0}, {4, 2})}, ""};
  EXPECT_TRUE(leaves(apart, {{1, 1}, {3, 1}}, rim));
}

// Sides that coincide cancel: a frame drawn in one stroke keeps its window out.
TEST(Outline, TheEvenOddRuleHoldsWhereSidesCoincide) {
  const Outline frame{
      {Polygon{{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}}}},
      ""};
  EXPECT_TRUE(covers(frame, {1, 3}, rim));
  EXPECT_FALSE(covers(frame, {3, 3}, rim));
  EXPECT_TRUE(covers(frame, {0.5, 1.5}, rim));
  EXPECT_TRUE(covers(frame, {1.5, 0.5}, rim));
  EXPECT_TRUE(leaves(frame, {{1, 3}, {5, 3}}, rim));
  EXPECT_FALSE(leaves(frame, {{0.5, 1.5}, {1.5, 0.5}}, rim));
}

TEST(Outline, ItsBoxHoldsAllAreas) {
  const Outline two{{Ellipse{{0, 0}, {1, 2}, 0}, Ring{{5, 5}, 2, 1}}, ""};
  EXPECT_NEAR((bounds(two).min - Vec2(-1, -2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((bounds(two).max - Vec2(7, 7)).norm(), 0.0, 1e-12);
  const Outline moved = transformed(two, {1, 1}, 2.0);
  EXPECT_NEAR((bounds(moved).max - Vec2(12, 12)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(covers(moved, {8, 11.5}, rim));
  EXPECT_FALSE(covers(moved, {8, 8}, rim));
}

}  // namespace
}  // namespace hackle
