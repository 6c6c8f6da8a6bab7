// SPDX-License-Identifier: MIT
#include "measure/averages.hpp"

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// A crack between rows 9 and 10 of 20, across the whole plate.
Simulation in_halves() {
  Plate plate = test::bare_plate(20, 20);
  plate.cracks.push_back({{0.0, 5e-3}, {10e-3, 5e-3}, Born::broken});
  return Simulation(plate, test::numerics(), {1});
}

// A linear field is its own mean inside the plate.
TEST(Averages, OfALinearFieldAreTheField) {
  const Simulation simulation(test::bare_plate(20, 20), test::numerics(), {1});
  const Grid& grid = simulation.lattice().grid;
  std::vector<float> values(grid.nodes());
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i)
      values[grid.index(i, j)] = 2.0F * static_cast<float>(i) - static_cast<float>(j);
  const std::vector<float> found = averaged(simulation, values);
  for (int j = 4; j < 16; ++j)
    for (int i = 4; i < 16; ++i)
      EXPECT_NEAR(found[grid.index(i, j)], values[grid.index(i, j)], 1e-5) << i << ' ' << j;
}

// Waves of two spacings are gone to what 48 bonds and the node itself leave: of the 49 nodes of a
// full horizon of four spacings 25 have one sign and 24 the other.
TEST(Averages, TakeOutTheShortestWaves) {
  const Simulation simulation(test::bare_plate(20, 20), test::numerics(), {1});
  const Grid& grid = simulation.lattice().grid;
  std::vector<float> values(grid.nodes());
  int same = 1, all = 1;
  simulation.lattice().family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
    same += (a + b) % 2 == 0 ? 2 : 0;
    all += 2;
  });
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i) values[grid.index(i, j)] = (i + j) % 2 == 0 ? 1.0F : -1.0F;
  const float left = averaged(simulation, values)[grid.index(10, 10)];
  EXPECT_NEAR(left, static_cast<double>(2 * same - all) / all, 1e-6);
  EXPECT_LT(std::abs(left), 0.2F);
}

TEST(Averages, DoNotReachAcrossACrack) {
  const Simulation simulation = in_halves();
  const Grid& grid = simulation.lattice().grid;
  std::vector<float> values(grid.nodes());
  std::vector<Stress> stress(grid.nodes());
  for (int j = 10; j < 20; ++j)
    for (int i = 0; i < 20; ++i) {
      values[grid.index(i, j)] = 1.0F;
      stress[grid.index(i, j)] = {1.0, 2.0, 3.0, 4.0};
    }
  EXPECT_EQ(averaged(simulation, values), values);
  const std::vector<Stress> found = averaged(simulation, stress);
  EXPECT_EQ(found[grid.index(5, 9)].xx, 0.0);
  EXPECT_DOUBLE_EQ(found[grid.index(5, 10)].yy, 2.0);
  EXPECT_DOUBLE_EQ(found[grid.index(5, 10)].xy, 3.0);
  EXPECT_DOUBLE_EQ(found[grid.index(5, 10)].zz, 4.0);
}

}  // namespace
}  // namespace hackle
