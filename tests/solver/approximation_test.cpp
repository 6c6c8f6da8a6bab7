// SPDX-License-Identifier: MIT
// Linearised forces, fused arithmetic and strength that varies from node to node.
#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "solver/simulation.hpp"
#include "support/agreement.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Numerics with_fidelity(double fidelity, Precision precision = Precision::f64) {
  Numerics numerics = test::numerics(0.25e-3, 1e-3);
  numerics.fidelity = fidelity;
  numerics.precision = precision;
  return numerics;
}

Simulation solved(const Plate& plate, const Numerics& numerics, Execution execution, int steps) {
  Simulation simulation(plate, numerics, execution);
  for (int n = 0; n < steps; ++n) simulation.step();
  return simulation;
}

std::int64_t tiles(const Simulation& simulation, Path path) {
  return simulation.path_counts()[static_cast<std::size_t>(path)];
}

TEST(Fidelity, NoneMeansNoLinearisedForce) {
  EXPECT_EQ(tiles(solved(test::edge_crack(12e6), with_fidelity(0.0), {1}, 20), Path::linear), 0);
  EXPECT_GT(tiles(solved(test::edge_crack(12e6), with_fidelity(0.5), {1}, 60), Path::linear), 1000);
}

// A linearised force lacks terms of second order in the strain, which is below `fidelity` times the
// critical stretch wherever it is used; with waves only, no error grows faster than that share.
TEST(Fidelity, TheErrorBeforeTheFirstBondBreaksIsOfTheSizeOfTheStrain) {
  const Simulation exact = solved(test::edge_crack(12e6), with_fidelity(0.0), {1}, 45);
  ASSERT_EQ(exact.state().bonds, exact.lattice().bonds);
  for (const double fidelity : {0.1, 0.5, 1.0}) {
    const Simulation near = solved(test::edge_crack(12e6), with_fidelity(fidelity), {1}, 45);
    EXPECT_GT(tiles(near, Path::linear), 100) << fidelity;
    EXPECT_LT(test::relative_difference(exact, near), fidelity * exact.lattice().calibration.s0)
        << fidelity;
  }
}

TEST(Fidelity, DoesNotDependOnThreadsOrInstructionSet) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    const Numerics numerics = with_fidelity(0.5, precision);
    const std::string hash =
        solved(test::edge_crack(24e6), numerics, {1, InstructionSet::baseline}, 80).state().hash();
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512})
      if (is_supported(set)) {
        EXPECT_EQ(solved(test::edge_crack(24e6), numerics, {1, set}, 80).state().hash(), hash);
      }
    for (const int threads : {2, 3, 5})
      EXPECT_EQ(solved(test::edge_crack(24e6), numerics, {threads}, 80).state().hash(), hash);
  }
}

TEST(Fidelity, KeepsTheMirrorImagesOfAnEvenNumberOfColumns) {
  Plate plate = test::edge_crack(24e6);
  plate.cracks = {{{0.025, 0.02}, {0.075, 0.02}, Born::broken}};
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    const Simulation simulation = solved(plate, with_fidelity(0.5, precision), {2}, 200);
    EXPECT_LT(simulation.state().bonds.count(), simulation.lattice().bonds.count());
    EXPECT_GT(tiles(simulation, Path::linear), 1000);
    EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
    EXPECT_EQ(test::asymmetric_nodes(simulation, false), 0);
  }
}

TEST(Fused, GivesTheSameBitsOnEveryMachineThatHasIt) {
  if (!can_fuse(InstructionSet::avx2) || !is_supported(InstructionSet::avx512))
    GTEST_SKIP() << "this machine lacks AVX2 with FMA, or AVX-512";
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    numerics.fused = true;
    const auto hash = [&](InstructionSet set) {
      return solved(test::edge_crack(24e6), numerics, {2, set}, 120).state().hash();
    };
    EXPECT_EQ(hash(InstructionSet::avx2), hash(InstructionSet::avx512));
  }
}

TEST(Fused, KeepsMirrorImagesAndStaysWithinRounding) {
  if (!can_fuse(best_instruction_set())) GTEST_SKIP() << "this machine has no fused arithmetic";
  Numerics numerics = test::numerics();
  const Simulation plain = solved(test::edge_crack(24e6), numerics, {1}, 100);
  numerics.fused = true;
  const Simulation fused = solved(test::edge_crack(24e6), numerics, {1}, 100);
  EXPECT_NE(plain.state().hash(), fused.state().hash());
  EXPECT_EQ(plain.state().bonds, fused.state().bonds);
  EXPECT_LT(test::relative_difference(plain, fused), 1e-11);
  EXPECT_EQ(test::asymmetric_nodes(fused, true), 0);
}

TEST(Fused, IsRefusedWhereThereIsNone) {
#ifdef __x86_64__
  Numerics numerics = test::numerics();
  numerics.fused = true;
  EXPECT_THROW(Simulation(test::bare_plate(20, 20), numerics, {1, InstructionSet::baseline}),
               Error);
#endif
}

// In a uniformly stretched plate, bonds along y break where the stretch exceeds that of the weaker
// end.
TEST(Strength, ABondBreaksByTheWeakerOfItsEnds) {
  const Plate plate = test::bare_plate(30, 20);
  const Lattice lattice(plate, test::numerics());
  std::mt19937 random(5);
  std::uniform_real_distribution<float> scatter(0.5F, 1.5F);
  std::vector<float> strength(lattice.grid.nodes());
  for (float& s : strength) s = scatter(random);
  Simulation simulation(plate, test::numerics(), {1}, strength);
  const double s = lattice.calibration.s0;
  simulation.restore(
      test::displaced(simulation, [&](const Vec2& x) { return Vec2(0, s * x.y()); }));
  simulation.step();
  for (int j = 0; j + 1 < 20; ++j)
    for (int i = 0; i < 30; ++i) {
      const float weaker =
          std::min(strength[lattice.grid.index(i, j)], strength[lattice.grid.index(i, j + 1)]);
      EXPECT_EQ(simulation.holds(i, j, 0, 1), weaker >= 1.0F) << i << "," << j;
      EXPECT_EQ(simulation.holds(i, j + 1, 0, -1), weaker >= 1.0F) << i << "," << j;
    }
}

TEST(Strength, OfOneEverywhereChangesNoBit) {
  const Plate plate = test::edge_crack(12e6);
  const std::vector<float> ones(16000, 1.0F);
  Simulation uniform(plate, test::numerics(), {1}), varied(plate, test::numerics(), {1}, ones);
  for (int n = 0; n < 120; ++n) uniform.step(), varied.step();
  EXPECT_EQ(uniform.state().hash(), varied.state().hash());
}

TEST(Strength, OfTheWrongSizeOrSignIsRefused) {
  const Plate plate = test::bare_plate(20, 20);
  EXPECT_THROW(Simulation(plate, test::numerics(), {1}, std::vector<float>(3, 1.0F)), Error);
  EXPECT_THROW(Simulation(plate, test::numerics(), {1}, std::vector<float>(400, 0.0F)), Error);
}

}  // namespace
}  // namespace hackle
