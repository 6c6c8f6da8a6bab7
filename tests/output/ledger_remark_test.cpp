// SPDX-License-Identifier: MIT
#include "output/ledger_remark.hpp"

#include <gmock/gmock.h>

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
  hot.loads.heatings.push_back({{}, ScalarField(-10.0), {}});
  hit.loads.impactors.push_back({{-3e-3, 2e-3}, 2e-3, {10.0, 0.0}, 0.1});
  damped.loads.damping = 3e6;
  EXPECT_THAT(of(hot), HasSubstr("how fast the temperature changes"));
  EXPECT_THAT(of(hit), HasSubstr("for the impact"));
  EXPECT_THAT(of(damped), HasSubstr("for the damping"));
  EXPECT_THAT(of(plate), HasSubstr("step = 1.05e-07 or less"));
}

}  // namespace
}  // namespace hackle
