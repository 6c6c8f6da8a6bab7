// SPDX-License-Identifier: MIT
// A hundred thousand steps: no drift of energy (src/solver/README.md 3.3 and 5.1).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// Returns the mean energy of the next 50 samples, 11 steps apart.
double mean_energy(Simulation& simulation) {
  double sum = 0.0;
  for (int n = 0; n < 50; ++n) {
    for (int k = 0; k < 11; ++k) simulation.step();
    const Energy now = energy(simulation);
    sum += now.kinetic + now.strain;
  }
  return sum / 50.0;
}

// Returns how far the mean energy of a vibrating plate deviates from its initial value.
double drift(Precision precision, int steps) {
  Numerics numerics = test::numerics();
  numerics.precision = precision;
  numerics.step = 50e-9;
  Simulation simulation(test::bare_plate(40, 16), numerics, {1});
  simulation.restore(test::displaced(simulation, [](const Vec2& x) {
    return Vec2(5e-5 * x.x() * std::cos(0.2 * x.y()), 2e-5 * x.y() + 4e-5 * x.x());
  }));
  const double start = mean_energy(simulation);
  double worst = 0.0;
  while (simulation.state().step < steps) {
    for (int n = 0; n < steps / 10; ++n) simulation.step();
    worst = std::max(worst, std::abs(mean_energy(simulation) / start - 1.0));
  }
  EXPECT_TRUE(simulation.state().bonds == simulation.lattice().bonds) << "it must stay elastic";
  return worst;
}

// At a fifth of the limit the energy of a mode varies by (omega dt)^2/4, at most 5 % for the
// shortest waves and 1e-3 for those of this plate; the mean of 50 samples by less than 2e-4.
TEST(Energy, DoesNotDriftInAHundredThousandSteps) {
  EXPECT_LT(drift(Precision::f64, 100000), 2e-4);
  EXPECT_LT(drift(Precision::f32, 100000), 2e-4);
}

// 2e5 rounding errors of 1e-16 of the amplitude, which waves of different phase spread. Measured:
// 2e-10 of it.
TEST(Time, CanBeReversedAfterAHundredThousandSteps) {
  Simulation simulation(test::bare_plate(24, 16), test::numerics(), {1});
  const State start = test::shaken(simulation.state(), 1e-6, 9);
  simulation.restore(start);
  for (int n = 0; n < 100000; ++n) simulation.step();
  simulation.restore(test::reversed(simulation));
  for (int n = 0; n < 100000; ++n) simulation.step();
  const State end = test::reversed(simulation);
  double worst = 0.0;
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 24; ++i) worst = std::max(worst, (end.v(i, j) - start.v(i, j)).norm());
  EXPECT_LT(worst, 1e-6 * 1e-8);
}

}  // namespace
}  // namespace hackle
