// SPDX-License-Identifier: MIT
// The step limit, and the behaviour at the extremes.
#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// Returns kinetic and strain energy after many steps at a share of the limit, relative to the
// start.
double growth(double share, double m) {
  Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
  const Simulation probe(test::bare_plate(48, 40), numerics);
  numerics.step = share * probe.lattice().step_limit;
  numerics.force_step = true;
  Simulation simulation(test::bare_plate(48, 40), numerics);
  simulation.restore(test::shaken(simulation.state(), 1e-9, 1));
  const double start = energy(simulation).kinetic;
  for (int n = 0; n < 2000; ++n) simulation.step();
  const Energy end = energy(simulation);
  return (end.kinetic + end.strain) / start;
}

TEST(Stability, BelowTheLimitEnergyStaysBounded) {
  // Near the limit the energy of the shortest waves varies by the factor 1/(1 - share^2), here 25.
  for (const double m : {2.0, 3.0, 4.0}) EXPECT_LT(growth(0.98, m), 30.0) << m;
}

TEST(Stability, AboveTheLimitItBlowsUp) {
  for (const double m : {2.0, 3.0, 4.0}) {
    const double grown = growth(1.02, m);
    EXPECT_TRUE(!std::isfinite(grown) || grown > 1e6) << m << ": " << grown;
  }
}

TEST(Stability, DivergenceIsReportedWithItsCause) {
  Numerics numerics = test::numerics();
  numerics.step = 600e-9;
  numerics.force_step = true;
  Plate plate = test::bare_plate(30, 20);
  plate.no_fail.push_back(strip(plate, Edge::top, plate.height));  // breaking would damp it
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e9}});
  Simulation simulation(plate, numerics);
  try {
    simulation.run(1e-3);
    FAIL() << "a step of 2.6 times the limit must diverge";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::run_failed);
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("diverged by step"),
                                             testing::HasSubstr("the step is 600 ns"),
                                             testing::HasSubstr("its limit 232")));
  }
}

TEST(Stability, AbsurdLoadsBreakThePlateButLeaveItFinite) {
  for (const double stress : {1e9, 1e12, 1e15}) {
    Plate plate = test::bare_plate(30, 20);
    plate.loads.tractions.push_back({Edge::top, {0.0, stress}});
    plate.loads.tractions.push_back({Edge::left, {-stress, stress}});
    Simulation simulation(plate, test::numerics());
    EXPECT_NO_THROW(simulation.run(20e-6)) << stress;
    EXPECT_GT(count_damage(simulation).broken_bonds, 0);
  }
}

TEST(Stability, TinyPlatesAndWideHorizonsWork) {
  for (const int nx : {1, 2, 3, 5})
    for (const int ny : {1, 2, 7})
      for (const double m : {2.0, 4.0, 16.0}) {
        Plate plate = test::bare_plate(nx, ny);
        plate.loads.tractions.push_back({Edge::top, {0.0, 1e6}});
        Simulation simulation(plate, test::numerics(0.5e-3, m * 0.5e-3));
        EXPECT_NO_THROW(simulation.run(2e-6)) << nx << " x " << ny << ", m = " << m;
      }
}

}  // namespace
}  // namespace hackle
