// SPDX-License-Identifier: MIT
// Elastic foundations against an oscillator, its rest and its energy.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr double bed = 2e14, bed_rho = 2235.0;  // N/m4, kg/m3: omega is 3e5/s

Plate bedded(double stiffness, Foundation::Along along = Foundation::Along::both) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.foundations.push_back({{}, stiffness, along});
  return plate;
}

Plate thrown(Plate plate, const Vec2& velocity) {
  plate.initial_conditions.push_back({{}, {}, velocity});
  return plate;
}

// A plate that moves as one has no force in its bonds. Leapfrog takes an oscillator through
// u(n) = v dt sin(n theta)/sin(theta), cos(theta) = 1 - (omega dt)^2/2.
TEST(Foundation, APlateThatMovesAsOneIsAnOscillator) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(thrown(bedded(bed), {2.0, -1.0}), numerics, {1});
    const double x = std::sqrt(bed / bed_rho) * simulation.dt(),
                 theta = std::acos(1.0 - 0.5 * x * x);
    EXPECT_NEAR(theta / x, 1.0, x * x / 20.0);  // the frequency sqrt(k/rho), to second order
    const double tolerance = precision == Precision::f64 ? 1e-9 : 1e-4;
    for (const int step : {1, 10, 50, 100}) {
      while (simulation.state().step < step) simulation.step();
      const double unit = simulation.dt() * std::sin(step * theta) / std::sin(theta);
      const double size = 2.0 / std::sqrt(bed / bed_rho);
      EXPECT_NEAR(simulation.displacement(3, 7).x(), 2.0 * unit, tolerance * size) << step;
      EXPECT_NEAR(simulation.displacement(19, 0).y(), -unit, tolerance * size) << step;
    }
  }
}

TEST(Foundation, LeavesTheOtherAxisFree) {
  Simulation simulation(thrown(bedded(bed, Foundation::Along::y), {2.0, 2.0}), test::numerics(),
                        {1});
  const double quarter = 0.5 * 3.14159265358979 / std::sqrt(bed / bed_rho);
  simulation.run(quarter);
  const double time = simulation.time(), x = 2.0 * time;
  EXPECT_NEAR(simulation.displacement(5, 5).x(), x, 1e-9 * x);
  // At its farthest, v/omega, where a moment more or less means nothing to first order.
  const double y = 2.0 / std::sqrt(bed / bed_rho);
  EXPECT_NEAR(simulation.displacement(5, 5).y(), y, 5e-3 * y);
}

// Several in one place add up, in any order.
TEST(Foundation, UnderABodyForceComesToRestAtForceOverStiffness) {
  Plate plate = test::bare_plate(20, 10);
  for (const double stiffness : {0.1 * bed, 0.7 * bed, 0.2 * bed})
    plate.loads.foundations.push_back({{}, stiffness, Foundation::Along::both});
  plate.loads.body_forces.push_back({{}, {3e9, -1e9}, {}});
  const double omega = std::sqrt(bed / bed_rho);
  plate.loads.damping = 2.0 * omega;  // critical
  Plate turned = plate;
  std::ranges::reverse(turned.loads.foundations);
  Simulation simulation(plate, test::numerics(), {1}), other(turned, test::numerics(), {1});
  simulation.run(25.0 / omega);  // 26 exp(-25) is left
  other.run(25.0 / omega);
  EXPECT_EQ(simulation.state().hash(), other.state().hash());
  const Vec2 rest = Vec2(3e9, -1e9) / bed;
  EXPECT_LT((simulation.displacement(4, 8) - rest).norm(), 1e-8 * rest.norm());
}

// Its work is -k/2 u^2 per volume, whatever the step: halves before and after a step telescope.
TEST(Foundation, TakesTheEnergyThatItStores) {
  Plate plate = test::bare_plate(24, 12);
  plate.loads.foundations.push_back(
      {rectangle({0, 0}, {6e-3, 6e-3}), 5.0 * bed, Foundation::Along::both});
  Simulation simulation(thrown(plate, {3.0, 1.0}), test::numerics(), {1});
  const double given = simulation.ledger().external;
  for (int n = 0; n < 200; ++n) {
    simulation.step();
    double stored = 0.0;
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i)
        stored += 2.5 * bed * 0.25e-6 * simulation.displacement(i, j).squaredNorm();
    EXPECT_NEAR(simulation.ledger().external, given - stored, 1e-9 * given) << n;
  }
}

TEST(Foundation, TheLedgerClosesToSecondOrderInTheStep) {
  double residual[2];
  for (const int fine : {0, 1}) {
    Plate plate = test::bare_plate(24, 12);
    plate.loads.foundations.push_back(
        {rectangle({0, 0}, {6e-3, 6e-3}), 5.0 * bed, Foundation::Along::both});
    Numerics numerics = test::numerics();
    numerics.step = fine == 0 ? 100e-9 : 50e-9;
    Simulation simulation(thrown(plate, {0.03, 0.01}), numerics, {1});
    simulation.run(5e-6);
    const Energy now = energy(simulation);
    residual[fine] = std::abs(now.residual()) / now.kinetic;
  }
  EXPECT_LT(residual[0], 1e-2);
  EXPECT_LT(residual[1], 0.35 * residual[0]);
}

// A bed that comes at a displacement u acts from half a step before: -k u times half of that step
// is its work there, then the rest telescopes.
TEST(Foundation, OneThatComesInARunDoesHalfItsFirstWorkInTheStepBefore) {
  Simulation simulation(thrown(test::bare_plate(20, 10), {2.0, 0.0}), test::numerics(), {1});
  const double given = simulation.ledger().external, area = 200 * 0.25e-6;
  simulation.run(2e-6);
  const double before = simulation.displacement(1, 1).x();
  simulation.step();
  const double u = simulation.displacement(1, 1).x();
  simulation.set_loads(bedded(bed).loads);
  simulation.run(2e-6);
  const double now = simulation.displacement(1, 1).x();
  const double stored = 0.5 * bed * area * (now * now - u * u);
  const double half = 0.5 * bed * area * u * (u - before);
  EXPECT_NEAR(simulation.ledger().external, given - stored - half, 1e-9 * given);
  const double x = std::sqrt(bed / bed_rho) * simulation.dt();
  EXPECT_NEAR(energy(simulation).residual(), 0.0, x * x * given);
}

// rho omega^2 of the lattice and the stiffness of the bed add up.
TEST(Foundation, LimitsTheStep) {
  const double free = Lattice(test::bare_plate(20, 10), test::numerics()).step_limit;
  const double stiffness = 3.0 * bed_rho * std::pow(2.0 / free, 2);
  const Plate plate = bedded(stiffness);
  EXPECT_NEAR(Lattice(plate, test::numerics()).step_limit, 0.5 * free, 1e-9 * free);
  Numerics numerics = test::numerics();
  numerics.step = 0.98 * 0.5 * free;
  Simulation simulation(plate, numerics, {1});
  simulation.restore(test::shaken(simulation.state(), 1e-6, 3));
  const double before = simulation.kinetic_energy();
  for (int n = 0; n < 2000; ++n) simulation.step();
  EXPECT_LT(simulation.kinetic_energy(), 30.0 * before);
  numerics.step = 1.02 * 0.5 * free;
  EXPECT_THROW(Simulation(plate, numerics, {1}), Error);
  Simulation unbedded(test::bare_plate(20, 10), test::numerics(), {1});
  try {
    unbedded.set_loads(plate.loads);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("above the stability limit"));
  }
}

TEST(Foundation, IsRefusedAtRestAndWhereThereIsNoNode) {
  Simulation simulation(bedded(bed), test::numerics(), {1});
  try {
    simulation.relax();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("relax: a plate on a foundation"));
  }
  Plate plate = test::bare_plate(20, 10);
  plate.loads.foundations.push_back(
      {rectangle({0.26e-3, 0.26e-3}, {0.7e-3, 0.7e-3}), bed, Foundation::Along::both});
  EXPECT_THROW(Simulation(plate, test::numerics(), {1}), Error);
}

}  // namespace
}  // namespace hackle
