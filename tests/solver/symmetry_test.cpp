// SPDX-License-Identifier: MIT
// A scene that is its own mirror image stays so to the last bit, for ever
// (src/solver/README.md 4.2).
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

class MirrorSymmetry : public testing::TestWithParam<std::tuple<Precision, double>> {
 protected:
  Simulation solve(Plate plate) const {
    const auto [precision, alpha] = GetParam();
    plate.material.alpha = alpha;
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    return Simulation(plate, numerics);
  }
};

TEST_P(MirrorSymmetry, AboutMidHeightIsNeverLost) {
  Simulation simulation = solve(test::edge_crack(24e6));
  for (int k = 0; k < 12; ++k) {
    simulation.run(5e-6);
    ASSERT_EQ(test::asymmetric_nodes(simulation, true), 0) << "at " << simulation.time();
  }
  EXPECT_LT(simulation.state().bonds.count(), simulation.lattice().bonds.count() - 5000);
}

TEST_P(MirrorSymmetry, AboutBothMidlinesIsNeverLost) {
  Plate plate = test::edge_crack(24e6);
  plate.cracks = {{{0.025, 0.02}, {0.075, 0.02}, Born::broken}};
  Simulation simulation = solve(plate);
  for (int k = 0; k < 12; ++k) {
    simulation.run(5e-6);
    ASSERT_EQ(test::asymmetric_nodes(simulation, true), 0) << "at " << simulation.time();
    ASSERT_EQ(test::asymmetric_nodes(simulation, false), 0) << "at " << simulation.time();
  }
  EXPECT_LT(simulation.state().bonds.count(), simulation.lattice().bonds.count() - 5000);
}

TEST_P(MirrorSymmetry, HoldsForOddLatticesWithACrackOnARowOfNodes) {
  Plate plate = test::bare_plate(61, 41);
  plate.cracks.push_back({{0.0, 0.5 * plate.height}, {0.5 * plate.width, 0.5 * plate.height}});
  plate.loads.tractions.push_back({Edge::top, {0.0, 30e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -30e6}});
  Simulation simulation = solve(plate);
  simulation.run(30e-6);
  EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
}

std::string name_of(const std::tuple<Precision, double>& kind) {
  return fmt::format("{}{}", name_of(std::get<0>(kind)), std::get<1>(kind) > 0.0 ? "_history" : "");
}

INSTANTIATE_TEST_SUITE_P(Kinds, MirrorSymmetry,
                         testing::Combine(testing::Values(Precision::f64, Precision::f32),
                                          testing::Values(0.0, 0.25)),
                         [](const auto& kind) { return name_of(kind.param); });

}  // namespace
}  // namespace hackle
