// SPDX-License-Identifier: MIT
// Fragments whose sizes and motions are prescribed.
#include "measure/fragment_list.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr double cell = 0.25e-6;  // m2, of 0.5 mm

// Makes a plate of 30 x 20 nodes cut into 5, 8 and 17 columns.
Simulation cut_plate() {
  Plate plate = test::bare_plate(30, 20);
  for (const double x : {2.5e-3, 6.5e-3}) plate.cracks.push_back({{x, 0.0}, {x, plate.height}});
  return Simulation(plate, test::numerics(), {1});
}

TEST(FragmentList, TellsSizesFromTheLargestOn) {
  const FragmentList found = measured_fragments(cut_plate());
  ASSERT_EQ(found.all.size(), 3U);
  const std::vector<int> columns{17, 8, 5};
  double passing = 30.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const MeasuredFragment& one = found.all[k];
    EXPECT_EQ(one.number, static_cast<int>(k) + 1);
    EXPECT_EQ(one.nodes, 20 * columns[k]);
    EXPECT_NEAR(one.area, 20 * columns[k] * cell, 1e-12 * one.area);
    EXPECT_NEAR(one.mass, 2235.0 * one.area, 1e-12 * one.mass);
    EXPECT_NEAR(one.diameter(), std::sqrt(4.0 * one.area / std::numbers::pi), 1e-15);
    EXPECT_NEAR(one.passing, passing / 30.0, 1e-12);
    passing -= columns[k];
  }
  EXPECT_NEAR(found.all[1].centre.x(), 4.5e-3, 1e-12);
  EXPECT_NEAR(found.all[1].centre.y(), 5e-3, 1e-12);
  EXPECT_EQ(found.dust, 0.0);
  EXPECT_NEAR(found.median_area(), 20 * 17 * cell, 1e-15);  // 13 of 30 columns are less than half
}

// Each fragment flies and turns about its own centre as a rigid body.
TEST(FragmentList, TellsVelocityAndSpinOfARigidMotion) {
  Simulation simulation = cut_plate();
  const Grid& grid = simulation.lattice().grid;
  const double dt = simulation.dt(), per_step = dt / grid.dx;  // m/s to dx per step
  const Vec2 middle(-6.0, 0.0);  // of the fragment of 8 columns, dx from the centre of the lattice
  const double spin = 300.0;
  simulation.restore(test::thrown(simulation, [&](const Vec2& x) {
    if (std::abs(x.x() - middle.x()) > 4.0) return Vec2(Vec2(1.5, 0.0) * per_step);
    const Vec2 arm = x - middle;
    return Vec2(Vec2(2.0, -3.0) * per_step + spin * dt * Vec2(-arm.y(), arm.x()));
  }));
  const FragmentList found = measured_fragments(simulation);
  const MeasuredFragment &turning = found.all[1], &gliding = found.all[0];
  EXPECT_NEAR(turning.velocity.x(), 2.0, 1e-9);
  EXPECT_NEAR(turning.velocity.y(), -3.0, 1e-9);
  EXPECT_NEAR(turning.spin, spin, 1e-9 * spin);
  EXPECT_NEAR(gliding.velocity.x(), 1.5, 1e-9);
  EXPECT_NEAR(gliding.spin, 0.0, 1e-6);
  EXPECT_NEAR(gliding.kinetic, 0.5 * gliding.mass * 1.5 * 1.5, 1e-9 * gliding.kinetic);
  // Moment of inertia of 8 x 20 points: mass dx2 (8^2 - 1 + 20^2 - 1)/12.
  const double inertia = turning.mass * grid.dx * grid.dx * (63.0 + 399.0) / 12.0;
  EXPECT_NEAR(turning.kinetic, 0.5 * turning.mass * 13.0 + 0.5 * inertia * spin * spin,
              1e-9 * turning.kinetic);
}

TEST(FragmentList, CountsNodesWithoutBondsAsDust) {
  Simulation simulation(test::bare_plate(12, 12), test::numerics());
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(x); }));
  simulation.step();
  const FragmentList found = measured_fragments(simulation);
  EXPECT_TRUE(found.all.empty());
  EXPECT_NEAR(found.dust, 144 * cell, 1e-15);
  EXPECT_EQ(found.median_area(), 0.0);
}

}  // namespace
}  // namespace hackle
