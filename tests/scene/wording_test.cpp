// SPDX-License-Identifier: MIT
#include "scene/wording.hpp"

#include <gtest/gtest.h>

#include "scene/plate.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

TEST(Wording, OfANounLeavesOutWhatAFreshOneHas) {
  const Wording words;
  EXPECT_EQ(words(Traction{}), "");
  EXPECT_EQ(words(Traction{Edge::top, {0.0, 12e6}}), "edge top, stress (0 Pa, 12 MPa)");
  Crack crack({0.0, 20e-3}, {50e-3, 20e-3});
  EXPECT_EQ(words(crack), "points (0 m, 20 mm) (50 mm, 20 mm)");
  crack.born = Born::absent;
  crack.name = "notch";
  EXPECT_EQ(words(crack), "points (0 m, 20 mm) (50 mm, 20 mm), born absent, name notch");
}

TEST(Wording, OfAKindNamesIt) {
  Support support;
  support.kind = Support::Kind::velocity;
  support.value = Vec2(1.0, 0.0);
  support.amplitude = ramp(2e-6);
  EXPECT_EQ(Wording()(support), "velocity (1 m/s, 0 m/s), time 0 at 0 s, 1 at 2 us");
}

TEST(Wording, OfAShapeNamesItOnce) {
  const Cutout hole{Ellipse{{0.08, 0.03}, {3e-3, 2e-3}}, "h"};
  EXPECT_EQ(Wording()(hole), "ellipse centre (80 mm, 30 mm), radii (3 mm, 2 mm), name h");
}

TEST(Wording, OfAFunctionSaysThatItIsOne) {
  Traction traction{Edge::top, VectorField([](const Vec2&) { return Vec2(0, 0); })};
  EXPECT_EQ(Wording()(traction), "edge top, stress a function of place");
}

TEST(Wording, LongListsAreCutUnlessAllDigitsMatter) {
  std::vector<Vec2> points;
  for (int k = 0; k < 20; ++k) points.emplace_back(k, 0.0);
  const Crack crack(points, Born::broken);
  EXPECT_TRUE(Wording()(crack).ends_with("(7 m, 0 m) ... (20 in all)")) << Wording()(crack);
  EXPECT_TRUE(Wording(Wording::Digits::all)(crack).ends_with("(18 m, 0 m) (19 m, 0 m)"));
}

TEST(Wording, AllDigitsTellNeighboursApart) {
  const double next = std::nextafter(12e6, 13e6);
  const Wording words(Wording::Digits::all);
  EXPECT_EQ(words(12e6, {.unit = "Pa"}), "12000000 Pa");
  EXPECT_EQ(words(next, {.unit = "Pa"}), "12000000.000000002 Pa");
}

}  // namespace
}  // namespace hackle
