// SPDX-License-Identifier: MIT
#include "measure/cracks.hpp"

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// Nodes at (0.5, 0.5), (1.5, 0.5), ... m.
constexpr int nx = 8, ny = 6;
const Grid grid{nx, ny, 1.0, {4.0, 3.0}};

Field none() {
  return {"damage", "", 1, std::vector<float>(grid.nodes())};
}

Nodes no_nodes() {
  return Nodes(grid.nodes());
}

TEST(Cracks, AnIntactPlateHasNone) {
  Field damage = none();
  damage.values[grid.index(3, 3)] = on_crack;
  EXPECT_EQ(nodes_on_crack(damage), no_nodes());
  const Cracks found = cracks(no_nodes(), no_nodes(), grid, 1.0, everywhere());
  EXPECT_EQ(found.nodes, 0);
  EXPECT_EQ(found.bands, 0);
  EXPECT_FALSE(found.fork);
}

TEST(Cracks, BoxAndBandsAreThoseOfTheArea) {
  Nodes nodes = no_nodes();
  for (int i = 1; i <= 5; ++i) nodes[grid.index(i, 1)] = 1;
  for (int i = 4; i <= 6; ++i) nodes[grid.index(i, 4)] = 1;
  const Cracks all = cracks(nodes, no_nodes(), grid, 1.0, everywhere());
  EXPECT_EQ(all.nodes, 8);
  EXPECT_EQ(all.box.min, Vec2(1.5, 1.5));
  EXPECT_EQ(all.box.max, Vec2(6.5, 4.5));
  EXPECT_EQ(all.bands, 2);
  EXPECT_FALSE(all.fork);
  EXPECT_EQ(cracks(nodes, no_nodes(), grid, 3.0, everywhere()).bands, 1) << "nearer than a horizon";
  const Cracks lower = cracks(nodes, no_nodes(), grid, 1.0, {{2, 0}, {8, 3}});
  EXPECT_EQ(lower.nodes, 4);
  EXPECT_EQ(lower.box.min, Vec2(2.5, 1.5));
  EXPECT_EQ(lower.box.max, Vec2(5.5, 1.5));
  EXPECT_EQ(lower.bands, 1);
}

TEST(Cracks, TheTipIsTheFarthestNode) {
  Nodes nodes = no_nodes();
  EXPECT_EQ(tip_place(nodes, grid), 0.0);
  for (int i = 1; i <= 5; ++i) nodes[grid.index(i, 2)] = 1;
  EXPECT_DOUBLE_EQ(tip_place(nodes, grid), 5.5);
  Plate plate = test::bare_plate(100, 40);
  plate.cracks.push_back({{10e-3, 10e-3}, {30e-3, 10e-3}});
  const Simulation simulation(plate, test::numerics(), {1});
  EXPECT_NEAR(tip_place(nodes_on_crack(damage(simulation)), simulation.lattice().grid), 30e-3,
              2e-3);  // a horizon: nodes there have lost fewer bonds
}

TEST(Foremost, IsTheFarthestNodeOnACrackInThatDirection) {
  Field damage = none();
  EXPECT_FALSE(foremost(damage, grid, {1, 0}));
  damage.values[grid.index(2, 1)] = 0.5F;
  damage.values[grid.index(5, 3)] = 0.5F;
  damage.values[grid.index(7, 4)] = on_crack;  // not above the threshold
  EXPECT_EQ(foremost(damage, grid, {1, 0}).value(), Vec2(5.5, 3.5));
  EXPECT_EQ(foremost(damage, grid, {-1, 0}).value(), Vec2(2.5, 1.5));
  EXPECT_EQ(foremost(damage, grid, {0, 1}).value(), Vec2(5.5, 3.5));
  EXPECT_EQ(foremost(damage, grid, {0, -1}).value(), Vec2(2.5, 1.5));
}

TEST(Foremost, OfTwoBranchesIsTheMiddle) {
  Field damage = none();
  for (const int j : {1, 4}) damage.values[grid.index(6, j)] = 0.5F;
  damage.values[grid.index(3, 5)] = 0.5F;
  EXPECT_EQ(foremost(damage, grid, {1, 0}).value(), Vec2(6.5, 3.0));
}

// Seen slightly from above or below, one branch lies a quarter of a spacing behind the other.
TEST(Foremost, OfBranchesWithinHalfASpacingIsTheirMiddleEitherWay) {
  Field damage = none();
  for (const int j : {1, 4}) damage.values[grid.index(6, j)] = 0.5F;
  for (const double tilt : {-0.085, 0.085})
    EXPECT_EQ(foremost(damage, grid, {1.0, tilt}).value(), Vec2(6.5, 3.0)) << tilt;
  for (const double tilt : {-0.5, 0.5})  // one and a half behind
    EXPECT_EQ(foremost(damage, grid, {1.0, tilt}).value(), Vec2(6.5, tilt < 0.0 ? 1.5 : 4.5));
}

}  // namespace
}  // namespace hackle
