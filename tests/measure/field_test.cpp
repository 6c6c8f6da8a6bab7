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
  state.set_v(5, 0, {0, 1e-3});  // lattice spacings a step
  simulation.restore(state);
  EXPECT_FLOAT_EQ(velocity(simulation).values[11],
                  static_cast<float>(1e-3 * 0.5e-3 / simulation.dt()));
}

}  // namespace
}  // namespace hackle
