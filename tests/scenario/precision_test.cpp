// SPDX-License-Identifier: MIT
// Single against double precision on a finer lattice.
#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/agreement.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// src/solver/README.md 5.1: 3e-7 at this spacing, and no bond differs.
TEST(SinglePrecision, BreaksTheSameBondsOnAFinerLattice) {
  const auto solve = [](Precision precision) {
    Numerics numerics = test::numerics(0.25e-3, 1e-3);
    numerics.precision = precision;
    Simulation simulation(test::edge_crack(12e6), numerics);
    simulation.run(32e-6);
    return simulation;
  };
  const Simulation exact = solve(Precision::f64), rounded = solve(Precision::f32);
  EXPECT_LT(exact.state().bonds.count(), exact.lattice().bonds.count() - 5000);
  EXPECT_TRUE(exact.state().bonds == rounded.state().bonds);
  EXPECT_LT(test::relative_difference(exact, rounded), 2e-6);
  EXPECT_FALSE(rounded.widened_at());
}

}  // namespace
}  // namespace hackle
