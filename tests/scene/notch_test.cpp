// SPDX-License-Identifier: MIT
#include "scene/notch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double tie = 1e-9;
constexpr double depth = 10e-3, width = 2e-3;  // m
constexpr std::array kinds{Notch::Kind::slot, Notch::Kind::v, Notch::Kind::u};

// The mouth of a notch, and from there the direction into the plate of 50 x 40 mm.
struct Mouth {
  Vec2 at, inward;
};
const std::array mouths{Mouth{{0.0, 0.02}, {1, 0}}, Mouth{{0.05, 0.02}, {-1, 0}},
                        Mouth{{0.025, 0.0}, {0, 1}}, Mouth{{0.025, 0.04}, {0, -1}}};

Plate plate() {
  return test::bare_plate(100, 80);
}

Vec2 turned(const Vec2& v, double angle) {
  return {v.x() * std::cos(angle) - v.y() * std::sin(angle),
          v.x() * std::sin(angle) + v.y() * std::cos(angle)};
}

constexpr int samples = 300;  // along each side of a box

struct Sampled {
  double area = 0.0, error = 0.0;
};

// Samples the area that a shape removes from the plate. The rim passes through some 4 n of the n^2
// samples, of which at most half are wrong, in either direction.
Sampled removed(const Shape& shape) {
  const Box box = bounds(shape);
  const Vec2 min = box.min.cwiseMax(Vec2(0, 0)), max = box.max.cwiseMin(Vec2(0.05, 0.04));
  const Vec2 size = max - min;
  int inside = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      inside +=
          is_inside(shape, min + size.cwiseProduct(Vec2(i + 0.5, j + 0.5) / samples), tie * 1e-3);
  return {inside * size.prod() / (samples * samples), size.prod() / samples};
}

// The fibres of a slot have its depth as their mean length; a round end removes a corner on either
// side; a V is a triangle whose sides leave the tip at angles a +- h.
double area_of(Notch::Kind kind, double angle) {
  if (kind == Notch::Kind::slot) return width * depth;
  if (kind == Notch::Kind::u)
    return width * (depth - 0.5 * width) + std::numbers::pi / 8.0 * width * width;
  const double half = std::atan(0.5 * width / depth), height = depth * std::cos(angle);
  return 0.5 * height * height * (std::tan(angle + half) - std::tan(angle - half));
}

TEST(Notch, HasItsDepthAndItsMouth) {
  for (const Notch::Kind kind : {Notch::Kind::slot, Notch::Kind::v, Notch::Kind::u}) {
    const Shape shape = shape_of({{0.0, 0.02}, 10e-3, 4e-3, kind, 0.0}, plate());
    EXPECT_TRUE(is_inside(shape, {9.9e-3, 0.02}, tie * 1e-3));
    EXPECT_FALSE(is_inside(shape, {10.1e-3, 0.02}, tie * 1e-3));
    for (const double y : {0.0181, 0.0219}) EXPECT_TRUE(is_inside(shape, {0.0, y}, tie * 1e-3));
    for (const double y : {0.0179, 0.0221}) EXPECT_FALSE(is_inside(shape, {0.0, y}, tie * 1e-3));
  }
}

TEST(Notch, FromACornerGoesAlongTheDiagonal) {
  const Shape shape = shape_of({{0.05, 0.04}, 10e-3, 2e-3, Notch::Kind::slot, 0.0}, plate());
  EXPECT_TRUE(is_inside(shape, {0.05 - 7e-3, 0.04 - 7e-3}, 1e-12));
  EXPECT_TRUE(is_inside(shape, {0.05, 0.04}, 1e-12));
}

TEST(Notch, RemovesItsAreaAtAnyAngleFromAnyEdge) {
  for (const Mouth& mouth : mouths)
    for (const Notch::Kind kind : kinds)
      for (const double angle : {-1.3, -0.9, -0.3, 0.0, 0.4, 1.0, 1.3}) {
        const Sampled found = removed(shape_of({mouth.at, depth, width, kind, angle}, plate()));
        EXPECT_NEAR(found.area, area_of(kind, angle), found.error)
            << notch_names[static_cast<std::size_t>(kind)] << ' ' << angle;
      }
}

TEST(Notch, TurnsAnticlockwiseFromThePerpendicularOfItsEdge) {
  for (const Mouth& mouth : mouths)
    for (const Notch::Kind kind : kinds)
      for (const double angle : {-1.2, -0.5, 0.0, 0.5, 1.2}) {
        const Shape shape = shape_of({mouth.at, depth, width, kind, angle}, plate());
        const Vec2 along = turned(mouth.inward, angle);
        EXPECT_TRUE(is_inside(shape, mouth.at + 0.99 * depth * along, tie * 1e-3)) << angle;
        EXPECT_FALSE(is_inside(shape, mouth.at + 1.01 * depth * along, tie * 1e-3)) << angle;
      }
}

// However oblique the notch is, no material remains across its mouth.
TEST(Notch, LeavesNothingAcrossItsMouth) {
  for (const Mouth& mouth : mouths)
    for (const Notch::Kind kind : {Notch::Kind::slot, Notch::Kind::u})
      for (const double angle : {-1.4, -1.3, -1.0, -0.5, 0.0, 0.5, 1.0, 1.3, 1.4}) {
        const Shape shape = shape_of({mouth.at, depth, width, kind, angle}, plate());
        const double half = 0.499 * width / std::cos(angle);
        const Vec2 edge = turned(mouth.inward, 0.5 * std::numbers::pi);
        for (int k = -20; k <= 20; ++k)
          EXPECT_TRUE(is_inside(shape, mouth.at + (k / 20.0) * half * edge, tie * 1e-3))
              << notch_names[static_cast<std::size_t>(kind)] << ' ' << angle << ' ' << k;
        for (const double beyond : {-1.01, 1.01})
          EXPECT_FALSE(is_inside(shape, mouth.at + beyond * half / 0.998 * edge, tie * 1e-3));
      }
}

std::size_t problems_of(const Notch& notch) {
  Problems problems;
  check(plate(), notch, problems);
  return problems.list().size();
}

TEST(Notch, MustBeginOnAnEdgeAndComeOutThere) {
  for (const Mouth& mouth : mouths) {
    EXPECT_EQ(problems_of({mouth.at, depth, width}), 0U);
    EXPECT_EQ(problems_of({mouth.at + 1e-3 * mouth.inward, depth, width}), 1U);
    EXPECT_EQ(problems_of({mouth.at - 1e-3 * mouth.inward, depth, width}), 1U);
    for (const double side : {-1.0, 1.0}) {
      EXPECT_EQ(problems_of({mouth.at, depth, width, Notch::Kind::slot, side * 1.45}), 0U);
      EXPECT_EQ(problems_of({mouth.at, depth, width, Notch::Kind::slot, side * 1.55}), 1U);
      EXPECT_EQ(problems_of({mouth.at, depth, width, Notch::Kind::v, side * 1.45}), 1U);  // 0.1 rad
    }
  }
}

}  // namespace
}  // namespace hackle
