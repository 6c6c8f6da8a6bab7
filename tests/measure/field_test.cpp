// SPDX-License-Identifier: MIT
#include "measure/field.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

TEST(Damage, IsZeroWithoutCracksAndBesideAbsentOnes) {
  Plate plate = test::bare_plate(20, 20);
  plate.cracks.push_back({{0.0, 0.005}, {0.005, 0.005}, Born::absent});
  for (const float value : damage(Simulation(plate, test::numerics())).values)
    EXPECT_EQ(value, 0.0F);
}

TEST(Damage, BesideACrackIsTheShareOfBondsThatCrossIt) {
  // m = 4, full: of 48 bonds of a node next to the cut, those with b >= 1 cross it: 20 of them.
  const Simulation simulation(test::edge_crack(12e6), test::numerics());
  const Field field = damage(simulation);
  EXPECT_EQ(field.values[simulation.lattice().grid.index(50, 40)], 20.0F / 48.0F);
}

TEST(Damage, OfAShatteredPlateIsOne) {
  Simulation simulation(test::bare_plate(12, 12), test::numerics());
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(x); }));
  simulation.step();
  for (const float value : damage(simulation).values) EXPECT_EQ(value, 1.0F);
}

TEST(Displacement, IsInMetres) {
  Simulation simulation(test::bare_plate(12, 12), test::numerics());
  simulation.restore(test::displaced(simulation, [](const Vec2&) { return Vec2(0.5, -0.25); }));
  const Field field = displacement(simulation);
  EXPECT_EQ(field.components, 2);
  EXPECT_FLOAT_EQ(field.values[0], 0.25e-3F);
  EXPECT_FLOAT_EQ(field.values[1], -0.125e-3F);
}

TEST(Velocity, IsInMetresPerSecond) {
  Simulation simulation(test::bare_plate(12, 12), test::numerics());
  State state = simulation.state();
  state.set_v(5, 0, {0, 1e-3});  // lattice spacings per step
  simulation.restore(state);
  EXPECT_FLOAT_EQ(velocity(simulation).values[11],
                  static_cast<float>(1e-3 * 0.5e-3 / simulation.dt()));
}

// The damage of one node must equal that of the field: inside, at edges, beside a crack, a hole and
// a broken bond.
TEST(Damage, OfOneNodeIsThatOfTheField) {
  Plate plate = test::bare_plate(24, 18);
  plate.cracks.push_back({{2e-3, 3e-3}, {7e-3, 6e-3}, Born::broken});
  plate.cutouts.push_back({Ellipse{{9e-3, 5e-3}, {1.2e-3, 1.2e-3}, 0.0}, ""});
  Simulation simulation(plate, test::numerics(), {1});
  State state = simulation.state();
  isolate(simulation.lattice().grid, simulation.lattice().family, 20, 2, state.bonds);
  simulation.restore(state);
  const Field field = damage(simulation);
  for (int j = 0; j < 18; ++j)
    for (int i = 0; i < 24; ++i)
      EXPECT_NEAR(damage_of(simulation, i, j), field.values[simulation.lattice().grid.index(i, j)],
                  1e-7)
          << i << ' ' << j;
  EXPECT_EQ(damage_of(simulation, 20, 2), 1.0);
}

// Each disc at its own position and with its own size, for any position of the plate; in metres.
TEST(Impactors, FlyWhereTheyWereThrown) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.impactors.push_back({{-9e-3, 4e-3}, 2e-3, {30.0, -20.0}, 10.0});
  plate.loads.impactors.push_back({{35e-3, 7e-3}, 3e-3, {-10.0, 5.0}, 20.0});
  Simulation simulation(plate, test::numerics(), {1});
  for (int step = 0; step < 10; ++step) simulation.step();
  const std::vector<Circle> discs = round_bodies(simulation);
  ASSERT_EQ(discs.size(), 2U);
  const double t = simulation.time();
  EXPECT_NEAR((discs[0].centre - Vec2(-9e-3 + 30.0 * t, 4e-3 - 20.0 * t)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((discs[1].centre - Vec2(35e-3 - 10.0 * t, 7e-3 + 5.0 * t)).norm(), 0.0, 1e-15);
  EXPECT_EQ(discs[0].radius, 2e-3);
  EXPECT_EQ(discs[1].radius, 3e-3);
}

TEST(RoundBodiesAndPlatens, AreWhereTheyWereLed) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.rollers.push_back({{5e-3, 15e-3}, 3e-3, {Guide::velocity, {0.0, 2.0}}});
  plate.loads.platens.push_back(
      {{20e-3, -3e-3}, {0.0, -1e-3}, {Guide::displacement, {0.0, -1e-3}, ramp(100e-6)}});
  Simulation simulation(plate, test::numerics(), {1});
  for (int step = 0; step < 10; ++step) simulation.step();
  const double t = simulation.time();
  const std::vector<Circle> discs = round_bodies(simulation);
  ASSERT_EQ(discs.size(), 1U);
  EXPECT_NEAR((discs[0].centre - Vec2(5e-3, 15e-3 + 2.0 * t)).norm(), 0.0, 1e-15);
  const std::vector<Box> boxes = platens(simulation);
  ASSERT_EQ(boxes.size(), 1U);
  const double way = 1e-3 * t / 100e-6;
  EXPECT_NEAR((boxes[0].min - Vec2(0.0, -3e-3 - way)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((boxes[0].max - Vec2(20e-3, -1e-3 - way)).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace hackle
