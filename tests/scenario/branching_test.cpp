// SPDX-License-Identifier: MIT
// The paper's first plate with 8 spacings per horizon, whose crack runs as one broad band for half
// of its way: no fork must be found before the crack forks, and the fork must lie where the middle
// lines of its branches meet, 67.3 mm by hand. A plate with a smaller load breaks straight through.
#include <gtest/gtest.h>

#include "measure/cracks.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

TEST(Branching, OfABroadCrackIsSeenOnceItHasForked) {
  Numerics numerics = test::numerics();
  numerics.spacing = 0.25e-3;
  numerics.horizon = 2e-3;
  numerics.precision = Precision::f32;
  Simulation simulation(test::edge_crack(12e6), numerics);
  for (; simulation.time() < 22.5e-6; simulation.run(1e-6))
    ASSERT_FALSE(cracks(simulation).fork) << simulation.time();
  simulation.run(28e-6 - simulation.time());
  const Cracks found = cracks(simulation);
  ASSERT_TRUE(found.fork);
  EXPECT_NEAR(*found.fork, 67.3e-3, 1e-3);  // half a horizon
  EXPECT_EQ(found.bands, 2);
}

TEST(Branching, IsNotSeenOnAStraightCrack) {
  for (const double m : {3.0, 4.0, 8.0}) {
    Numerics numerics = test::numerics();
    numerics.horizon = m * numerics.spacing;
    Plate plate = test::edge_crack(3e6);
    Simulation simulation(plate, numerics);
    for (; simulation.time() < 60e-6; simulation.run(4e-6))
      ASSERT_FALSE(cracks(simulation).fork) << m << " at " << simulation.time();
  }
}

}  // namespace
}  // namespace hackle
