// SPDX-License-Identifier: MIT
#include "measure/links.hpp"

#include <gtest/gtest.h>

#include "measure/bond_lines.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// A crack between rows 9 and 10, from the left edge to the middle of 20 columns.
Simulation cracked() {
  Plate plate = test::bare_plate(20, 20);
  plate.cracks.push_back({{0.0, 5e-3}, {5e-3, 5e-3}, Born::broken});
  return Simulation(plate, test::numerics(), {1});
}

TEST(Links, OfAWholePlateAreAllThatStayInsideIt) {
  const Simulation simulation(test::bare_plate(20, 20), test::numerics(), {1});
  const Grid& grid = simulation.lattice().grid;
  const auto all = links(simulation);
  EXPECT_EQ(all[grid.index(10, 10)],
            Link::right | Link::above_right | Link::above | Link::above_left);
  EXPECT_EQ(all[grid.index(0, 5)], Link::right | Link::above_right | Link::above);
  EXPECT_EQ(all[grid.index(19, 5)], Link::above | Link::above_left);
  EXPECT_EQ(all[grid.index(5, 19)], Link::right);
}

TEST(Links, ACrackLeavesThoseAlongItAndNoneAcross) {
  const Simulation simulation = cracked();
  const Grid& grid = simulation.lattice().grid;
  const auto all = links(simulation);
  EXPECT_EQ(all[grid.index(4, 9)], Link::right);
  EXPECT_EQ(all[grid.index(4, 8)],
            Link::right | Link::above_right | Link::above | Link::above_left);
  EXPECT_EQ(all[grid.index(14, 9)],
            Link::right | Link::above_right | Link::above | Link::above_left);
}

TEST(BondLines, AreThoseKeptByTheNodesOfTheBlockTheBrokenOnesLast) {
  Simulation simulation = cracked();
  State state = simulation.state();
  isolate(simulation.lattice().grid, simulation.lattice().family, 15, 15, state.bonds);
  simulation.restore(state);
  const auto lines = bond_lines(simulation, {15, 15, 15, 15});
  ASSERT_EQ(static_cast<int>(lines.size()), simulation.lattice().family.kept());
  for (const BondLine& line : lines) EXPECT_FALSE(line.holds);

  const auto beside = bond_lines(simulation, {14, 14, 15, 15});
  ASSERT_EQ(static_cast<int>(beside.size()), simulation.lattice().family.kept());
  EXPECT_TRUE(beside.front().holds);
  EXPECT_FALSE(beside.back().holds);
  EXPECT_EQ(beside.back().column, 1);
  EXPECT_EQ(beside.back().row, 0);
}

TEST(BondLines, ABlockMayReachBeyondTheLattice) {
  const Simulation simulation(test::bare_plate(20, 20), test::numerics(), {1});
  EXPECT_EQ(static_cast<std::int64_t>(bond_lines(simulation, {-5, 40, -5, 40}).size()),
            simulation.lattice().initial_bonds());
}

// Compares place, direction and state of each line with a query bond by bond.
TEST(BondLines, AreTheBondsOfTheState) {
  Simulation simulation = cracked();
  State state = simulation.state();
  isolate(simulation.lattice().grid, simulation.lattice().family, 15, 15, state.bonds);
  simulation.restore(state);
  const Lattice& lattice = simulation.lattice();
  int broken = 0;
  for (const BondLine& line : bond_lines(simulation, {12, 17, 11, 18})) {
    EXPECT_TRUE(line.i >= 12 && line.i <= 17 && line.j >= 11 && line.j <= 18);
    EXPECT_TRUE(
        holds(lattice.grid, lattice.family, lattice.bonds, line.i, line.j, line.column, line.row));
    EXPECT_EQ(simulation.holds(line.i, line.j, line.column, line.row), line.holds);
    broken += line.holds ? 0 : 1;
  }
  EXPECT_GT(broken, lattice.family.kept());  // including bonds that other nodes keep
}

}  // namespace
}  // namespace hackle
