// SPDX-License-Identifier: MIT
// On both sides of the step limit.
#include <cmath>
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "support/outcome.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// Makes an unbreakable plate with random velocities, solved at a share of the step limit.
Simulation shaken_plate(int nx, int ny, double m, double share, Precision precision) {
  Plate plate = test::bare_plate(nx, ny);
  plate.no_fail.push_back(strip(plate, Edge::top, plate.height));
  Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
  numerics.precision = precision;
  numerics.step = share * Simulation(plate, numerics, {1}).lattice().step_limit;
  numerics.force_step = true;
  Simulation simulation(plate, numerics, {1});
  simulation.restore(test::shaken(simulation.state(), 1e-7, 1));
  return simulation;
}

class StepLimit : public testing::TestWithParam<double> {};

TEST_P(StepLimit, BelowItEnergyStaysBoundedForAHundredThousandSteps) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Simulation simulation = shaken_plate(16, 12, GetParam(), 0.98, precision);
    const double start = energy(simulation).kinetic;
    simulation.run((precision == Precision::f64 ? 100000 : 20000) * simulation.dt());
    // The energy of the shortest waves varies by the factor 1/(1 - share^2), here 25.
    const Energy end = energy(simulation);
    EXPECT_LT((end.kinetic + end.strain) / start, 30.0);
    EXPECT_GT((end.kinetic + end.strain) / start, 1.0 / 30.0);
    test::expect_numbers(simulation, "0.98");
  }
}

TEST_P(StepLimit, AboveItTheRunStopsAndNamesTimeAndPlace) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    // Wide enough for the wave of the highest frequency.
    const int size = static_cast<int>(10.0 * GetParam());
    Simulation simulation = shaken_plate(size, size, GetParam(), 1.02, precision);
    try {
      simulation.run(1e5 * simulation.dt());
      ADD_FAILURE() << "it must diverge";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::run_failed);
      const std::regex form(
          "the solution has diverged by step [0-9]+, at [0-9.]+ [mun]?s, at "
          "\\([0-9.]+ [a-z]*m, [0-9.]+ [a-z]*m\\): the step is [0-9.]+ ns, its limit [0-9.]+ ns.*");
      EXPECT_TRUE(std::regex_match(error.what(), form)) << error.what();
      EXPECT_LT(simulation.state().step, 20000);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Horizons, StepLimit, testing::Values(2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0),
                         [](const auto& m) { return fmt::format("m{:.0f}", m.param); });

TEST(StepLimit, AStepAboveItIsRefusedUnlessForced) {
  Numerics numerics = test::numerics();
  const Plate plate = test::bare_plate(20, 20);
  numerics.step = 1.0001 * Simulation(plate, numerics, {1}).lattice().step_limit;
  EXPECT_EQ(test::outcome(plate, numerics, 1, "1.0001"), test::Outcome::refused);
}

}  // namespace
}  // namespace hackle
