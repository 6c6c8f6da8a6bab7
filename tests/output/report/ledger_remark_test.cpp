// SPDX-License-Identifier: MIT
#include "output/report/ledger_remark.hpp"

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

Energy ledger(double external, double kinetic) {
  Energy energy;
  energy.external = external;
  energy.kinetic = kinetic;
  return energy;
}

TEST(LedgerRemark, IsForMoreThanATwentiethOfTheLargestEntry) {
  const Simulation simulation(test::bare_plate(20, 10), test::numerics());
  EXPECT_EQ(ledger_remark(simulation, Energy{}), std::nullopt);
  EXPECT_EQ(ledger_remark(simulation, ledger(1.0, 0.96)), std::nullopt);
  EXPECT_THAT(ledger_remark(simulation, ledger(1.0, 0.94)).value_or(""),
              HasSubstr("6 % of the largest is lost"));
  EXPECT_THAT(ledger_remark(simulation, ledger(1.0, 2.0)).value_or(""),
              HasSubstr("50 % of the largest comes from nowhere"));
  EXPECT_DOUBLE_EQ(residual_share(ledger(-1.0, 0.0)), -1.0);
}

TEST(LedgerRemark, NamesWhatTheSceneHas) {
  Plate plate = test::bare_plate(20, 10);
  plate.material.alphaT = 3.3e-6;
  const auto of = [&](const Plate& other) {
    return ledger_remark(Simulation(other, test::numerics()), ledger(1.0, 2.0)).value_or("");
  };
  EXPECT_THAT(of(plate), HasSubstr("the step is long for what happens"));
  Plate hot = plate, hit = plate, damped = plate;
  hot.loads.thermal_loads.push_back({{}, ScalarField(-10.0), {}});
  hit.loads.impactors.push_back({{-3e-3, 2e-3}, 2e-3, {10.0, 0.0}, 0.1});
  damped.loads.damping = 3e6;
  EXPECT_THAT(of(hot), HasSubstr("how fast the temperature changes"));
  EXPECT_THAT(of(hit), HasSubstr("for the impact"));
  EXPECT_THAT(of(damped), HasSubstr("for the damping"));
  EXPECT_THAT(of(plate), HasSubstr("step = 1e-07 or less"));
}

// The ledger of a plate that was only moved, or heated freely, contains nothing but rounding and
// nonlinear terms.
TEST(LedgerRemark, IsSilentWhereNothingHappened) {
  Plate plate = test::bare_plate(20, 10);
  plate.material.alphaT = 1e-5;
  plate.loads.thermal_loads.push_back({{}, ScalarField(-300.0), ramp(3e-6)});
  Simulation simulation(plate, test::numerics());
  simulation.load_slowly({3e-6, 1, 1e-6, {}});
  EXPECT_EQ(ledger_remark(simulation, energy(simulation)), std::nullopt);
  Plate carried = test::bare_plate(20, 10);
  carried.loads.supports.push_back({.region = strip(carried, Edge::top, 1e-3),
                                    .value = Vec2(14e-6, 0.0),
                                    .amplitude = ramp(2e-6)});
  Simulation moved(carried, test::numerics());
  moved.load_slowly({3e-6, 3, 1e-6, {}});
  moved.run(2e-6);
  EXPECT_EQ(ledger_remark(moved, energy(moved)), std::nullopt);
}

// Far below the nonlinear part of what heat does, but bonds have broken.
TEST(LedgerRemark, SpeaksWhereHeatHasBrokenBonds) {
  Plate plate = test::bare_plate(20, 10);
  plate.material.alphaT = 3e-6;
  plate.loads.thermal_loads.push_back({{}, ScalarField(1e4), {}});
  const Simulation simulation(plate, test::numerics());
  Energy energy = ledger(1.0, 2.0);
  EXPECT_EQ(ledger_remark(simulation, energy), std::nullopt);
  energy.broken = 0.5;
  EXPECT_NE(ledger_remark(simulation, energy), std::nullopt);
}

TEST(LedgerRemark, AdvisesWhatHelps) {
  Simulation simulation(test::bare_plate(20, 10), test::numerics());
  EXPECT_THAT(ledger_remark(simulation, ledger(1.0, 2.0), true).value_or(""),
              testing::AllOf(HasSubstr("a ramp"), testing::Not(HasSubstr("step ="))));
  Plate pulled = test::bare_plate(20, 10);
  pulled.loads.tractions = {{Edge::top, {0.0, 1e6}, 0.0, {}}, {Edge::bottom, {0.0, -1e6}, 0.0, {}}};
  Simulation slow(pulled, test::numerics());
  slow.load_slowly({1e-6, 1, 1e-6, {}});
  EXPECT_THAT(ledger_remark(slow, ledger(1.0, 2.0)).value_or(""),
              testing::AllOf(HasSubstr("more increments"), testing::Not(HasSubstr("step ="))));
}

}  // namespace
}  // namespace hackle
