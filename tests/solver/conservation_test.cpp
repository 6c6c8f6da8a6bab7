// SPDX-License-Identifier: MIT
// What velocity Verlet with pairwise central forces conserves (src/solver/README.md 3.3).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

struct Momentum {
  double x = 0.0, y = 0.0, angular = 0.0;
  double size = 0.0;  // sum of the absolute contributions to `angular`
};

Momentum momentum(const Simulation& simulation) {
  // Leapfrog keeps the sum of u(n) x v(n - 1/2): forces are along x, and v moves x along itself.
  const Grid& grid = simulation.lattice().grid;
  const State& state = simulation.state();
  Momentum sum;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 x = grid.from_centre(i, j) + state.origin + state.u(i, j), v = state.v(i, j);
      const double turn = x.x() * v.y() - x.y() * v.x();
      sum.x += v.x();
      sum.y += v.y();
      sum.angular += turn;
      sum.size += std::abs(turn);
    }
  return sum;
}

// A free plate that spins, drifts and shakes.
Simulation thrown_plate() {
  Simulation simulation(test::bare_plate(30, 20), test::numerics());
  State state = test::thrown(
      simulation, [](const Vec2& x) { return Vec2(1e-3 - 1e-3 * x.y(), 2e-3 + 1e-3 * x.x()); });
  simulation.restore(test::shaken(std::move(state), 1e-5, 3));
  return simulation;
}

TEST(Conservation, OfLinearAndAngularMomentum) {
  Simulation simulation = thrown_plate();
  const Momentum before = momentum(simulation);
  for (int n = 0; n < 500; ++n) simulation.step();
  const Momentum after = momentum(simulation);
  ASSERT_EQ(simulation.state().bonds, simulation.lattice().bonds) << "the test must stay elastic";
  // 600 nodes, 500 steps, rounding of each sum about eps of its size.
  EXPECT_NEAR(after.x, before.x, 1e-12);
  EXPECT_NEAR(after.y, before.y, 1e-12);
  EXPECT_NEAR(after.angular / before.size, before.angular / before.size, 1e-12);
}

// The mean energy over 60 samples, 7 steps apart.
double mean_energy(Simulation& simulation) {
  double sum = 0.0;
  for (int n = 0; n < 60; ++n) {
    for (int k = 0; k < 7; ++k) simulation.step();
    const Energy now = energy(simulation);
    sum += now.kinetic + now.strain;
  }
  return sum / 60.0;
}

TEST(Conservation, OfEnergyWithoutDriftInTenThousandSteps) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    numerics.step = 50e-9;
    Simulation simulation(test::bare_plate(24, 16), numerics, {1});
    simulation.restore(test::shaken(simulation.state(), 1e-5, 5));
    const double early = mean_energy(simulation);
    for (int n = 0; n < 10000; ++n) simulation.step();
    // At a fifth of the limit the energy of the shortest waves swings by 5 %; the mean over 768
    // modes and 60 samples by some 1e-4 of it.
    EXPECT_NEAR(mean_energy(simulation) / early, 1.0, 1e-3);
  }
}

// Largest deviation of the total energy in 12 us of ringing after a step load was let go.
double energy_error(double dt) {
  Numerics numerics = test::numerics();
  numerics.step = dt;
  Simulation simulation(test::bare_plate(24, 16), numerics);
  simulation.restore(test::displaced(simulation, [](const Vec2& x) {
    return Vec2(1e-4 * x.x() * std::cos(0.3 * x.y()), 2e-4 * x.y());
  }));
  const double start = energy(simulation).strain;
  double worst = 0.0;
  while (simulation.time() < 12e-6) {
    simulation.step();
    const Energy now = energy(simulation);
    worst = std::max(worst, std::abs(now.kinetic + now.strain - start) / start);
  }
  return worst;
}

TEST(Conservation, TheEnergyErrorFallsWithTheSquareOfTheStep) {
  const double coarse = energy_error(40e-9), fine = energy_error(20e-9);
  EXPECT_NEAR(coarse / fine, 4.0, 0.4);
}

TEST(Conservation, TimeCanBeReversed) {
  Simulation simulation(test::bare_plate(30, 20), test::numerics());
  const State start = test::shaken(simulation.state(), 1e-5, 9);
  simulation.restore(start);
  for (int n = 0; n < 300; ++n) simulation.step();
  simulation.restore(test::reversed(simulation));
  for (int n = 0; n < 300; ++n) simulation.step();
  ASSERT_EQ(simulation.state().bonds, simulation.lattice().bonds) << "the test must stay elastic";
  const State end = test::reversed(simulation);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 30; ++i) {
      EXPECT_LT((end.v(i, j) - start.v(i, j)).norm(), 1e-5 * 1e-10);
      EXPECT_LT(end.u(i, j).norm(), 1e-5 * 1e-9);
    }
}

TEST(Conservation, ExternalWorkIsForceTimesDisplacement) {
  Plate plate = test::bare_plate(30, 20);
  plate.loads.tractions.push_back({Edge::top, {1e6, 2e6}});
  plate.loads.tractions.push_back({Edge::bottom, {-1e6, -2e6}});
  Simulation simulation(plate, test::numerics());
  simulation.run(5e-6);
  const Lattice& lattice = simulation.lattice();
  double work = 0.0;
  for (const LoadedNode& load : simulation.actions().forces) {
    const Vec2 u = simulation.displacement(load.i, load.j);
    work += lattice.rho * lattice.grid.dx * lattice.grid.dx * load.acceleration.dot(u);
  }
  EXPECT_NEAR(simulation.ledger().external / work, 1.0, 1e-12);
}

}  // namespace
}  // namespace hackle
