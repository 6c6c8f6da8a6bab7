// SPDX-License-Identifier: MIT
// The same bits every time, and mirror symmetry for ever (DESIGN promise: kernel.md 2).
#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Plate centre_crack(double stress) {
  Plate plate = test::edge_crack(stress);
  plate.cracks = {{{0.025, 0.02}, {0.075, 0.02}, Born::broken}};
  return plate;
}

std::string hash_after(double duration, Execution execution, const Plate& plate) {
  Simulation simulation(plate, test::numerics(), execution);
  simulation.run(duration);
  return simulation.state().hash();
}

TEST(Reproducibility, DoesNotDependOnThreads) {
  const Plate plate = test::edge_crack(24e6);
  const std::string alone = hash_after(12e-6, {1}, plate);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash_after(12e-6, {threads}, plate), alone);
}

TEST(Reproducibility, DoesNotDependOnTheInstructionSet) {
  const Plate plate = test::edge_crack(24e6);
  const std::string baseline = hash_after(12e-6, {1, InstructionSet::baseline}, plate);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_supported(set)) continue;
    EXPECT_EQ(hash_after(12e-6, {1, set}, plate), baseline);
  }
}

TEST(Reproducibility, DoesNotDependOnHowARunIsCut) {
  const Plate plate = test::edge_crack(24e6);
  Simulation simulation(plate, test::numerics(), {1});
  for (const double part : {1e-6, 3.3e-6, 0.0, 7.7e-6}) simulation.run(part);
  EXPECT_EQ(simulation.state().hash(), hash_after(12e-6, {1}, plate));
}

TEST(Reproducibility, AKeptStateGoesOnToTheSameBits) {
  Simulation simulation(test::edge_crack(24e6), test::numerics(), {1});
  simulation.run(8e-6);
  const State kept = simulation.state();
  simulation.run(4e-6);
  const std::string straight = simulation.state().hash();
  simulation.restore(kept);
  EXPECT_EQ(simulation.state().hash(), kept.hash());
  while (simulation.time() < 12e-6) simulation.step();
  EXPECT_EQ(simulation.state().hash(), straight);
}

TEST(Reproducibility, ACopyIsAnotherFuture) {
  Simulation one(test::edge_crack(24e6), test::numerics(), {1});
  one.run(6e-6);
  Simulation other = one;
  one.run(3e-6);
  other.run(3e-6);
  EXPECT_EQ(one.state().hash(), other.state().hash());
}

TEST(MirrorSymmetry, AboutMidHeightIsNeverLost) {
  Simulation simulation(test::edge_crack(24e6), test::numerics());
  for (int k = 0; k < 8; ++k) {
    simulation.run(5e-6);
    ASSERT_EQ(test::asymmetric_nodes(simulation, true), 0) << "at " << simulation.time();
  }
  ASSERT_GT(simulation.lattice().bonds.count(), simulation.state().bonds.count());
}

TEST(MirrorSymmetry, AboutBothMidlinesIsNeverLost) {
  Simulation simulation(centre_crack(24e6), test::numerics());
  for (int k = 0; k < 6; ++k) {
    simulation.run(5e-6);
    ASSERT_EQ(test::asymmetric_nodes(simulation, true), 0) << "at " << simulation.time();
    ASSERT_EQ(test::asymmetric_nodes(simulation, false), 0) << "at " << simulation.time();
  }
}

TEST(MirrorSymmetry, HoldsForOddLatticesWithACrackOnARowOfNodes) {
  Plate plate = test::bare_plate(61, 41);
  plate.cracks.push_back({{0.0, 0.5 * plate.height}, {0.5 * plate.width, 0.5 * plate.height}});
  plate.tractions.push_back({Edge::top, {0.0, 30e6}});
  plate.tractions.push_back({Edge::bottom, {0.0, -30e6}});
  Simulation simulation(plate, test::numerics());
  simulation.run(15e-6);
  EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
}

TEST(Bonds, TheTwoEndsAlwaysAgree) {
  Plate plate = test::edge_crack(24e6);
  plate.cracks.push_back({{0.061, 0.013}, {0.083, 0.017}, Born::broken});
  Simulation simulation(plate, test::numerics());
  simulation.run(30e-6);
  EXPECT_EQ(test::one_sided_bonds(simulation), 0);
}

}  // namespace
}  // namespace hackle
