// SPDX-License-Identifier: MIT
#include "scene/shape.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr double tie = 1e-9;

// Returns the share of sample points of a box that a shape covers, times the area of the box.
double area(const Shape& shape) {
  const Box box = bounds(shape);
  const Vec2 size = box.max - box.min;
  constexpr int n = 400;
  int inside = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      inside += is_inside(shape, box.min + size.cwiseProduct(Vec2(i + 0.5, j + 0.5) / n), tie);
  return inside * size.prod() / (n * n);
}

// The rim passes through some 4 n of the n^2 samples, of which at most half are wrong.
TEST(Shape, HasItsArea) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(area(Ellipse{{1, 2}, {3, 1}, 0.4}), 3.0 * pi, 0.02 * 3.0 * pi);
  EXPECT_NEAR(area(Ring{{1, 2}, 3, 2}), 5.0 * pi, 0.04 * 5.0 * pi);
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
  EXPECT_FALSE(cuts(box, {{-1, 1}, {1, -1}}, tie));  // at its corner
  EXPECT_TRUE(cuts(box, {{-1, 1.1}, {1.1, -1}}, tie));
  EXPECT_TRUE(cuts(box, {{0.5, 0.5}, {1.5, 1.5}}, tie));  // wholly inside
  const Shape picture = Bitmap{{0, 0}, {2, 2}, 2, 2, {1, 0, 0, 1}};
  EXPECT_FALSE(cuts(picture, {{0, 2}, {2, 0}}, tie));  // between the two cells
  EXPECT_TRUE(cuts(picture, {{0, 0}, {2, 2}}, tie));
}

// Row by row from below, for a bitmap of any shape.
TEST(Shape, ABitmapIsInsideWhereItIsMarked) {
  for (const auto& [columns, rows] : {std::pair(3, 2), std::pair(2, 3), std::pair(1, 6)})
    for (int marked = 0; marked < 6; ++marked) {
      std::vector<std::uint8_t> inside(6, 0);
      inside[static_cast<std::size_t>(marked)] = 1;
      const Shape picture = Bitmap{{1, 2}, {1.0 + columns, 2.0 + rows}, columns, rows, inside};
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
          EXPECT_EQ(is_inside(picture, {1.5 + i, 2.5 + j}, tie), j * columns + i == marked)
              << columns << " x " << rows << ": " << i << ", " << j;
    }
}

TEST(Shape, ASegmentCutsWhenAnyOfItsPointsIsInside) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  const std::vector<Shape> shapes{
      Ellipse{{0.3, 0.1}, {2, 0.5}, 0.7}, Capsule{{{-1, 0}, {1, 1}}, 0.4},
      Polygon{{{-2, -2}, {2, -1}, {0, 0}, {1, 2}}}, Ring{{0.4, -0.3}, 1.9, 1.2},
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
      if (!found && cuts(shape, segment, tie)) {  // by less than the distance of samples
        EXPECT_FALSE(cuts(shape, segment, 0.005)) << kind_of(shape) << trial;
      }
    }
}

TEST(Shape, WithoutAreaIsRefused) {
  for (const Shape& shape :
       std::vector<Shape>{Polygon{{{0, 0}, {1, 1}}}, Polygon{{{0, 0}, {1, 1}, {3, 3}}},
                          Ellipse{{0, 0}, {0, 1}, 0}, Ellipse{{0, 0}, {1.0, INFINITY}, 0},
                          Ring{{0, 0}, 1, 1}, Ring{{0, 0}, 1, 2}, rectangle({1, 1}, {1, 2})}) {
    Problems problems;
    check(shape, "hole", problems);
    EXPECT_FALSE(problems.empty()) << kind_of(shape);
  }
}

// A quarter turn and back: points along the long axis are inside, their mirror images are not.
TEST(Shape, AnEllipseIsTurnedAnticlockwise) {
  for (double angle = -7.0; angle < 7.0; angle += 0.37) {
    const Vec2 centre(0.3, -0.2), along(std::cos(angle), std::sin(angle));
    const Shape shape = Ellipse{centre, {3.0, 0.1}, angle};
    EXPECT_TRUE(is_inside(shape, centre + 2.9 * along, tie)) << angle;
    EXPECT_FALSE(is_inside(shape, centre + 3.1 * along, tie)) << angle;
    if (std::abs(along.y()) > 0.1 && std::abs(along.x()) > 0.1) {
      EXPECT_FALSE(is_inside(shape, centre + 2.9 * Vec2(along.x(), -along.y()), tie)) << angle;
    }
  }
}

// The outermost samples of the area touch every side of the box, to one sample.
TEST(Shape, HasTheLeastBoxThatHoldsIt) {
  for (const Shape& shape :
       std::vector<Shape>{Ellipse{{1, 2}, {3, 1}, 0.4}, Ellipse{{-1, 2}, {1, 3}, -1.1},
                          Capsule{{{0, 0}, {-3, 4}}, 0.5}, Capsule{{{5, -1}, {3, -4}}, 1.5},
                          Polygon{{{4, 3}, {-1, 0}, {4, -2}}}, Ring{{1, -2}, 3, 2.5},
                          Bitmap{{1, 2}, {4, 3}, 2, 2, {1, 0, 0, 1}}}) {
    const Box box = bounds(shape);
    constexpr int n = 600;
    const Vec2 from(-8, -8), sample = Vec2(16, 16) / n;
    Box seen{{99, 99}, {-99, -99}};
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec2 at = from + sample.cwiseProduct(Vec2(i + 0.5, j + 0.5));
        if (is_inside(shape, at, tie)) seen = {seen.min.cwiseMin(at), seen.max.cwiseMax(at)};
      }
    // A round or sharp end may lie between samples; at its tip it is at most 10 samples wide.
    EXPECT_NEAR((seen.min - box.min).cwiseAbs().maxCoeff(), 0.0, 10 * sample.x()) << kind_of(shape);
    EXPECT_NEAR((seen.max - box.max).cwiseAbs().maxCoeff(), 0.0, 10 * sample.x()) << kind_of(shape);
    EXPECT_GE((seen.min - box.min).minCoeff(), 0.0) << kind_of(shape);
    EXPECT_GE((box.max - seen.max).minCoeff(), 0.0) << kind_of(shape);
  }
}

TEST(Shape, MovedAndScaledCoversTheSamePlaces) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  const Vec2 origin(0.7, -1.3);
  for (const Shape& shape :
       std::vector<Shape>{Ellipse{{0.3, 0.1}, {2, 0.5}, 0.7}, Capsule{{{-1, 0}, {1, 1}}, 0.4},
                          Polygon{{{-2, -2}, {2, -1}, {0, 0}, {1, 2}}}, Ring{{0.4, -0.3}, 1.9, 1.2},
                          Bitmap{{-2, -1}, {2, 2}, 2, 3, {1, 0, 0, 1, 1, 1}}}) {
    const Shape moved = transformed(shape, origin, 2.5);
    for (int trial = 0; trial < 400; ++trial) {
      const Vec2 at(place(random), place(random));
      EXPECT_EQ(is_inside(shape, at, tie), is_inside(moved, 2.5 * (at - origin), tie))
          << kind_of(shape);
    }
  }
}

}  // namespace
}  // namespace hackle
