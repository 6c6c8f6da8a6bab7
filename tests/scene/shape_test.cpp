// SPDX-License-Identifier: MIT
#include "scene/shape.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "scene/notch.hpp"
#include "scene/random_cracks.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double tie = 1e-9;

// Share of points of a box that a shape covers, times the area of the box.
double area(const Shape& shape) {
  const Box box = bounds(shape);
  const Vec2 size = box.most - box.least;
  constexpr int n = 400;
  int inside = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      inside += is_inside(shape, box.least + size.cwiseProduct(Vec2(i + 0.5, j + 0.5) / n), tie);
  return inside * size.prod() / (n * n);
}

// The rim passes through some 4 n of the n^2 samples: half of them at most are wrong.
TEST(Shape, HasItsArea) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(area(Ellipse{{1, 2}, {3, 1}, 0.4}), 3.0 * pi, 0.02 * 3.0 * pi);
  EXPECT_NEAR(area(Capsule{{{0, 0}, {3, 4}}, 0.5}), 5.0 + 0.25 * pi, 0.02 * 14.0);
  EXPECT_NEAR(area(Polygon{{{0, 0}, {4, 0}, {4, 3}}}), 6.0, 0.06);
  EXPECT_NEAR(area(Polygon{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}), 8.0, 0.08);  // even-odd
  EXPECT_DOUBLE_EQ(area(Bitmap{{0, 0}, {2, 2}, 2, 2, {1, 0, 0, 1}}), 2.0);
}

TEST(Shape, ARimIsCoveredAndNotInside) {
  const Shape disc = Ellipse{{0, 0}, {5, 5}, 0.3}, box = rectangle({0, 0}, {2, 2});
  const Shape slot = Capsule{{{0, 0}, {4, 0}}, 1.0}, picture = Bitmap{{0, 0}, {2, 2}, 1, 1, {1}};
  for (const auto& [shape, at] : {std::pair{disc, Vec2(3, 4)},
                                  {disc, Vec2(-5, 0)},
                                  {box, Vec2(1, 0)},
                                  {box, Vec2(2, 2)},
                                  {slot, Vec2(2, 1)},
                                  {slot, Vec2(5, 0)},
                                  {picture, Vec2(2, 1)},
                                  {picture, Vec2(0, 0)}}) {
    EXPECT_TRUE(covers(shape, at, tie)) << kind_of(shape);
    EXPECT_FALSE(is_inside(shape, at, tie)) << kind_of(shape);
  }
}

TEST(Shape, ASegmentThatOnlyTouchesTheRimDoesNotCut) {
  const Shape disc = Ellipse{{0, 0}, {2, 2}, 0.0}, box = rectangle({0, 0}, {2, 2});
  EXPECT_FALSE(cuts(disc, {{-5, 2}, {5, 2}}, tie));
  EXPECT_TRUE(cuts(disc, {{-5, 1.99}, {5, 1.99}}, tie));
  EXPECT_FALSE(cuts(box, {{-1, 2}, {3, 2}}, tie));
  EXPECT_FALSE(cuts(box, {{-1, 1}, {1, -1}}, tie));  // by its corner
  EXPECT_TRUE(cuts(box, {{-1, 1.1}, {1.1, -1}}, tie));
  EXPECT_TRUE(cuts(box, {{0.5, 0.5}, {1.5, 1.5}}, tie));  // wholly inside
  const Shape picture = Bitmap{{0, 0}, {2, 2}, 2, 2, {1, 0, 0, 1}};
  EXPECT_FALSE(cuts(picture, {{0, 2}, {2, 0}}, tie));  // between the two cells
  EXPECT_TRUE(cuts(picture, {{0, 0}, {2, 2}}, tie));
}

TEST(Shape, ASegmentCutsWhenAnyOfItsPointsIsInside) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  const std::vector<Shape> shapes{Ellipse{{0.3, 0.1}, {2, 0.5}, 0.7},
                                  Capsule{{{-1, 0}, {1, 1}}, 0.4},
                                  Polygon{{{-2, -2}, {2, -1}, {0, 0}, {1, 2}}},
                                  Bitmap{{-2, -2}, {2, 2}, 3, 3, {1, 0, 1, 0, 0, 1, 1, 1, 0}}};
  for (const Shape& shape : shapes)
    for (int trial = 0; trial < 300; ++trial) {
      const Segment segment{{place(random), place(random)}, {place(random), place(random)}};
      bool found = false;
      for (int k = 0; k <= 2000 && !found; ++k)
        found = is_inside(shape, segment.from + (k / 2000.0) * (segment.to - segment.from), tie);
      const Box box{segment.from.cwiseMin(segment.to), segment.from.cwiseMax(segment.to)};
      if (found) {
        EXPECT_TRUE(cuts(shape, segment, tie)) << kind_of(shape) << trial;
        EXPECT_TRUE(may_cut(shape, box, tie)) << kind_of(shape) << trial;
      }
      if (!found && cuts(shape, segment, tie)) {  // by less than a sample
        EXPECT_FALSE(cuts(shape, segment, 0.005)) << kind_of(shape) << trial;
      }
    }
}

TEST(Shape, WithoutAreaIsRefused) {
  for (const Shape& shape : std::vector<Shape>{
           Polygon{{{0, 0}, {1, 1}}}, Polygon{{{0, 0}, {1, 1}, {3, 3}}}, Ellipse{{0, 0}, {0, 1}, 0},
           Ellipse{{0, 0}, {1.0, INFINITY}, 0}, rectangle({1, 1}, {1, 2})}) {
    Problems problems;
    check(shape, "hole", problems);
    EXPECT_FALSE(problems.empty()) << kind_of(shape);
  }
}

TEST(Notch, HasItsDepthAndItsMouth) {
  const Plate plate = test::bare_plate(100, 80);  // 50 x 40 mm
  for (const Notch::Kind kind : {Notch::Kind::slot, Notch::Kind::v, Notch::Kind::u}) {
    const Shape shape = shape_of({{0.0, 0.02}, 10e-3, 4e-3, kind, 0.0}, plate);
    EXPECT_TRUE(is_inside(shape, {9.9e-3, 0.02}, tie * 1e-3));
    EXPECT_FALSE(is_inside(shape, {10.1e-3, 0.02}, tie * 1e-3));
    for (const double y : {0.0181, 0.0219}) EXPECT_TRUE(is_inside(shape, {0.0, y}, tie * 1e-3));
    for (const double y : {0.0179, 0.0221}) EXPECT_FALSE(is_inside(shape, {0.0, y}, tie * 1e-3));
  }
}

TEST(Notch, FromACornerGoesAlongTheDiagonal) {
  const Plate plate = test::bare_plate(100, 80);
  const Shape shape = shape_of({{0.05, 0.04}, 10e-3, 2e-3, Notch::Kind::slot, 0.0}, plate);
  EXPECT_TRUE(is_inside(shape, {0.05 - 7e-3, 0.04 - 7e-3}, 1e-12));
  EXPECT_TRUE(is_inside(shape, {0.05, 0.04}, 1e-12));
}

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

}  // namespace
}  // namespace hackle
