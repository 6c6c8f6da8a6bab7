// SPDX-License-Identifier: MIT
#include "solver/statics/fragments.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

struct Plates {
  explicit Plates(const Plate& plate)
      : lattice(plate, test::numerics()), state(lattice, Precision::f64), mobile(state.layout) {
    for (double& value : mobile.x) value = 1.0;
    for (double& value : mobile.y) value = 1.0;
  }
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(state.layout.at(i, j)); }
  Fragments fragments() const { return Fragments(lattice, state, mobile, Threads(2)); }

  Lattice lattice;
  State state;
  NodeVectors mobile;
};

TEST(Fragments, APlateIsOneAndACutMakesTwo) {
  Plate plate = test::bare_plate(30, 20);
  EXPECT_EQ(Plates(plate).fragments().list().size(), 1U);
  plate.cracks.push_back({{5e-3, 0.0}, {5e-3, plate.height}});
  const Fragments two = Plates(plate).fragments();
  ASSERT_EQ(two.list().size(), 2U);
  EXPECT_EQ(two.list()[0].nodes, 10 * 20);
  EXPECT_EQ(two.list()[1].nodes, 20 * 20);
  EXPECT_EQ(two.list()[0].centre, Vec2(-10.0, 0.0));
}

TEST(Fragments, ANodeWithoutBondsBelongsToNone) {
  Plates scene(test::bare_plate(30, 20));
  isolate(scene.lattice.grid, scene.lattice.family, 7, 7, scene.state.bonds);
  ASSERT_EQ(scene.fragments().list().size(), 1U);
  EXPECT_EQ(scene.fragments().list()[0].nodes, 599);
}

TEST(Fragments, SupportsTakeAwayMotions) {
  Plates scene(test::bare_plate(30, 20));
  const auto motions = [&] { return scene.fragments().list()[0].motions.size(); };
  EXPECT_EQ(motions(), 3U);
  scene.mobile.x[scene.at(3, 4)] = 0.0;
  EXPECT_EQ(motions(), 2U);
  scene.mobile.x[scene.at(9, 4)] = 0.0;  // on the same line
  EXPECT_EQ(motions(), 2U);
  scene.mobile.y[scene.at(9, 4)] = 0.0;
  EXPECT_EQ(motions(), 1U);  // turns about a pin
  scene.mobile.y[scene.at(20, 4)] = 0.0;
  EXPECT_EQ(motions(), 0U);
}

TEST(Fragments, WhatIsRigidIsTakenOutAndNothingElse) {
  const Plates scene(test::bare_plate(31, 20));
  const Fragments fragments = scene.fragments();
  NodeVectors vector(scene.state.layout);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 31; ++i) {
      const Vec2 x = scene.lattice.grid.from_centre(i, j);
      vector.x[scene.at(i, j)] = 3.0 - 0.5 * x.y() + 0.25 * x.x();
      vector.y[scene.at(i, j)] = 2.0 + 0.5 * x.x();
    }
  fragments.take_out_rigid(vector);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 31; ++i) {
      ASSERT_NEAR(vector.x[scene.at(i, j)], 0.25 * scene.lattice.grid.from_centre(i, j).x(), 1e-12);
      ASSERT_NEAR(vector.y[scene.at(i, j)], 0.0, 1e-12);
    }
}

TEST(Fragments, TurningKeepsDistancesAndTheMeanPlace) {
  const Plates scene(test::bare_plate(31, 20));
  NodeVectors u(scene.state.layout);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 31; ++i) u.x[scene.at(i, j)] = 0.5;
  scene.fragments().turn(0, 1.25, u);
  const Vec2 corner = scene.lattice.grid.from_centre(30, 0);
  const std::size_t at = scene.at(30, 0);
  const Vec2 moved = corner + Vec2(u.x[at] - 0.5, u.y[at]);
  EXPECT_NEAR(moved.norm(), corner.norm(), 1e-12);
  EXPECT_NEAR(std::atan2(moved.y(), moved.x()) - std::atan2(corner.y(), corner.x()), 1.25, 1e-12);
}

}  // namespace
}  // namespace hackle
