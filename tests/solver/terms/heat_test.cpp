// SPDX-License-Identifier: MIT
// Changes of temperature.
#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "support/composite.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Plate heated(int nx, int ny, double change, Amplitude amplitude = {}) {
  Plate plate = test::bare_plate(nx, ny);
  plate.material.alphaT = 9e-6;
  plate.loads.thermal_loads.push_back({std::nullopt, change, std::move(amplitude)});
  return plate;
}

std::string refusal(const Plate& plate) {
  try {
    Simulation simulation(plate, test::numerics(), {1});
    simulation.run(3e-6);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

// A stretch s has e = (1 + s)^2 - 1, and at rest e is 2 alphaT dT.
TEST(Heat, AFreePlateThatHasExpandedIsAtRest) {
  for (const double change : {1.0, 100.0, -500.0}) {
    Plate plate = heated(30, 20, change);
    plate.no_fail.push_back(strip(plate, Edge::top, plate.height));
    Simulation simulation(plate, test::numerics(), {1});
    const double pressed = test::largest(test::accelerations(simulation));
    const double e = 2.0 * 9e-6 * change, s = e / (1.0 + std::sqrt(1.0 + e));
    EXPECT_NEAR(s / (9e-6 * change), 1.0, 9e-6 * std::abs(change));
    simulation.restore(test::displaced(simulation, [&](const Vec2& x) { return Vec2(s * x); }));
    // Rounding of a displacement of at most 15 s, in bonds of length 1 and above: 15 eps.
    EXPECT_LT(test::largest(test::accelerations(simulation)), 100.0 * 2.2e-16 * pressed) << change;
    EXPECT_LT(energy(simulation).strain, 1e-20);
  }
}

TEST(Heat, AFreePlateExpandsByAlphaTTimesTheChange) {
  Plate plate = heated(30, 20, 200.0, ramp(10e-6));
  plate.loads.damping = 4e5;
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(100e-6);
  const double grown = simulation.displacement(29, 10).x() - simulation.displacement(0, 10).x();
  // Damped for 40 relaxation times; second order in the strain is 9e-4 of it.
  EXPECT_NEAR(grown / (29 * 0.5e-3 * 9e-6 * 200.0), 1.0, 1e-3);
  EXPECT_LT(energy(simulation).strain, 1e-6 * simulation.ledger().external);
}

// x t as a function of place and time is x with a ramp: the table of a straight line is exact.
TEST(Heat, MayBeAFunctionOfPlaceAndTime) {
  Plate apart = heated(30, 20, 0.0, Amplitude({{0.0, 0.0}, {1e-3, 1e-3}})), together = apart;
  apart.loads.thermal_loads[0].change =
      ScalarField(std::function<double(const Vec2&)>([](const Vec2& at) { return 1e9 * at.x(); }));
  together.loads.thermal_loads[0].amplitude = {};
  together.loads.thermal_loads[0].change = ScalarField(std::function<double(const Vec2&, double)>(
      [](const Vec2& at, double t) { return 1e9 * at.x() * t; }));
  Simulation one(apart, test::numerics(), {1}), other(together, test::numerics(), {1});
  one.run(10e-6);
  other.run(10e-6);
  const double u = one.displacement(29, 10).x();
  EXPECT_GT(u, 1e-7);
  EXPECT_NEAR(other.displacement(29, 10).x(), u, 1e-9 * u);
  EXPECT_NEAR(energy(other).external, energy(one).external, 1e-9 * energy(one).external);
}

// The force across the middle of the plate, along x, over its height and Young's modulus.
double mean_strain_that_pulls(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  const double middle = 0.5 * grid.nx;
  double force = 0.0;
  lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    for (int j = 0; j + b < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        if (!grid.contains(i + a, j + b) || (i < middle) == (i + a < middle)) continue;
        const Vec2 h = simulation.state().u(i + a, j + b) - simulation.state().u(i, j);
        const double heat = simulation.thermal_strain()[grid.index(i, j)] +
                            simulation.thermal_strain()[grid.index(i + a, j + b)];
        const double s = (h.dot(h + 2.0 * xi) / xi.squaredNorm() - heat) / 2.0;
        force += weight * s * std::abs(xi.x()) / xi.norm();
      }
  });
  return force * lattice.calibration.c * std::pow(grid.dx, 3) /
         (grid.ny * lattice.calibration.moduli.E);
}

// Held at its ends, free across: stress -E alphaT dT.
TEST(Heat, AHeatedPlateBetweenWallsIsPressedByEAlphaTTimesTheChange) {
  Plate plate = heated(60, 60, 100.0, ramp(5e-6));
  for (const Edge edge : {Edge::left, Edge::right})
    plate.loads.supports.push_back({strip(plate, edge, 1e-3), Support::Kind::displacement,
                                    Vec2(0, 0), true, false, Amplitude()});
  plate.loads.damping = 4e5;
  Simulation simulation(plate, test::numerics(0.5e-3, 1e-3), {1});
  simulation.run(60e-6);
  // The bonds of the outermost m rows on either side are incomplete: m/ny of the stiffness at most.
  EXPECT_NEAR(mean_strain_that_pulls(simulation) / (-9e-6 * 100.0), 1.0, 2.0 / 60.0);
}

TEST(Heat, WhatIsFarFromItStaysStill) {
  Plate plate = test::bare_plate(200, 100);
  plate.material.alphaT = 9e-6;
  plate.loads.thermal_loads.push_back({test::disc({25e-3, 25e-3}, 3e-3), 100.0, Amplitude()});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.step();
  EXPECT_GT(simulation.path_counts()[static_cast<int>(Path::still)], 50);
  EXPECT_GT(test::largest(simulation.velocities()), 0.0);
  EXPECT_EQ(simulation.state().v(180, 50), Vec2(0, 0));
}

// Cold enough, a held plate breaks: at s0 = alphaT dT.
TEST(Heat, CoolingBreaksAPlateThatIsHeld) {
  const double s0 = Simulation(test::bare_plate(30, 30), test::numerics()).lattice().calibration.s0;
  for (const double share : {0.98, 1.02}) {
    Plate plate = heated(30, 30, -share * s0 / 9e-6);
    plate.loads.supports.push_back(
        {std::nullopt, Support::Kind::displacement, Vec2(0, 0), true, true, Amplitude()});
    Simulation simulation(plate, test::numerics(), {1});
    simulation.step();
    EXPECT_EQ(simulation.state().bonds.count() == 0, share > 1.0) << share;
  }
}

TEST(Heat, CanBeTurnedOnAndOffWhileThePlateIsSolved) {
  Simulation simulation(test::composite(40, 30, {.mixed = true}), test::numerics(), {1});
  simulation.run(1e-6);
  EXPECT_EQ(energy(simulation).kinetic, 0.0);
  Loads loads;
  loads.thermal_loads.push_back({std::nullopt, 20.0, Amplitude()});
  simulation.set_loads(loads);
  EXPECT_NEAR(energy(simulation).strain / simulation.ledger().external, 1.0, 1e-12);
  simulation.run(3e-6);
  const Energy before = energy(simulation);
  EXPECT_GT(before.kinetic, 0.0);
  EXPECT_LT(std::abs(before.residual()), 0.05 * before.external);
  simulation.set_loads({});
  EXPECT_TRUE(simulation.thermal_strain().empty());
  const Energy after = energy(simulation);
  // Strain and the motion half a step on change at once: all but the square of the latter's change,
  // which is of the order of (omega dt)^2.
  EXPECT_NEAR(after.residual(), before.residual(), 0.05 * std::abs(after.strain - before.strain));
  EXPECT_NO_THROW(simulation.run(3e-6));
}

// Node by node: alphaT of the material there times the sum of what acts, each by its own amplitude.
TEST(Heat, OfSeveralChangesAddsUpInEveryMaterial) {
  Plate plate = test::bare_plate(40, 20);  // 20 x 10 mm
  plate.material.alphaT = 4e-6;
  plate.inclusions.push_back({rectangle({0, 0}, {5e-3, 10e-3}), test::resin()});
  plate.loads.thermal_loads.push_back({{}, -30.0, ramp(2e-6)});
  plate.loads.thermal_loads.push_back({rectangle({0, 0}, {20e-3, 5e-3}),
                                       ScalarField([](const Vec2& x) { return 2000.0 * x.x(); }),
                                       step_at(1e-6)});
  Simulation simulation(plate, test::numerics(), {1});
  for (int step = 0; step < 12; ++step) {
    const double t = simulation.time();
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 40; ++i) {
        const double change = -30.0 * std::min(t / 2e-6, 1.0) +
                              (j < 10 && t >= 1e-6 ? 2000.0 * (i + 0.5) * 0.5e-3 : 0.0);
        const double alphaT = i < 10 ? 60e-6 : 4e-6;
        ASSERT_NEAR(simulation.thermal_strain()[static_cast<std::size_t>(40 * j + i)],
                    alphaT * change, 1e-15)
            << t << ' ' << i << ' ' << j;
      }
    simulation.step();
  }
}

TEST(Heat, IsRefusedWhereNothingExpandsOrTooMuchDoes) {
  using testing::HasSubstr;
  Plate plate = heated(40, 30, 100.0);
  EXPECT_EQ(refusal(plate), "");
  plate.material.alphaT = 0.0;
  EXPECT_THAT(refusal(plate), HasSubstr("Duran 50 glass does not expand, its alphaT is 0"));
  plate.inclusions.push_back({test::disc({5e-3, 5e-3}, 2e-3), test::resin()});
  EXPECT_EQ(refusal(plate), "");
  plate.loads.thermal_loads.front().region = test::disc({15e-3, 5e-3}, 2e-3);
  EXPECT_THAT(refusal(plate), HasSubstr("there is no node whose material expands"));
  EXPECT_THAT(refusal(heated(40, 30, 1e5)), HasSubstr("strains the material by 0.9"));
  EXPECT_THAT(refusal(heated(40, 30, -1e5)), HasSubstr("strains the material by -0.9"));
  EXPECT_THAT(refusal(heated(40, 30, 1e4, Amplitude({{0.0, 1.0}, {2e-6, 1e6}}))),
              HasSubstr("strains the material by"));
  plate.material.alphaT = -1e-6;
  EXPECT_THAT(refusal(plate), HasSubstr("alphaT is -1e-06 1/K, it must be at least 0"));
}

}  // namespace
}  // namespace hackle
