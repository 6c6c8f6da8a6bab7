// SPDX-License-Identifier: MIT
#include "measure/gaps.hpp"

#include <gtest/gtest.h>

#include "measure/field.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// A crack between rows 9 and 10 of 20, from the left edge to the middle.
Simulation with_crack(Born born, bool holed = false) {
  Plate plate = test::bare_plate(20, 20);
  plate.cracks.push_back({{0.0, 5e-3}, {5e-3, 5e-3}, born});
  if (holed) plate.cutouts.push_back({rectangle({6e-3, 6e-3}, {9e-3, 9e-3}), ""});
  return Simulation(plate, test::numerics(), {1});
}

TEST(Gaps, AreTheDamageWhereNoCrackIsAbsent) {
  const Simulation simulation = with_crack(Born::broken);
  EXPECT_EQ(gaps(simulation), damage(simulation).values);
}

// However the crack came about, the same bonds are gone.
TEST(Gaps, OfAnAbsentCrackAreThoseOfABrokenOne) {
  for (const bool holed : {false, true}) {
    const Simulation absent = with_crack(Born::absent, holed);
    const std::vector<float> found = gaps(absent);
    EXPECT_EQ(found, gaps(with_crack(Born::broken, holed))) << holed;
    const Grid& grid = absent.lattice().grid;
    // m = 4: of 48 bonds those with b >= 1 cross the cut, 20 of them.
    EXPECT_EQ(found[grid.index(5, 9)], 20.0F / 48.0F);
    EXPECT_EQ(damage(absent).values[grid.index(5, 9)], 0.0F);
    EXPECT_EQ(found[grid.index(15, 9)], 0.0F);
  }
}

TEST(Gaps, GrowAsBondsBreakBesideAnAbsentCrack) {
  Simulation simulation = with_crack(Born::absent);
  State state = simulation.state();
  isolate(simulation.lattice().grid, simulation.lattice().family, 5, 9, state.bonds);
  simulation.restore(state);
  EXPECT_EQ(gaps(simulation)[simulation.lattice().grid.index(5, 9)], 1.0F);
}

}  // namespace
}  // namespace hackle
