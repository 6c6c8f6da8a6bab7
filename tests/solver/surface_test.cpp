// SPDX-License-Identifier: MIT
// Stiffened surfaces change neither what is conserved nor what the bits depend on.
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/agreement.hpp"
#include "support/mirror.hpp"
#include "support/reference.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Numerics stiffened(Surface surface, double m = 4.0) {
  Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
  numerics.surface = surface;
  return numerics;
}

// Edges, a slanted crack, a hole, and a bridge of a few nodes between them.
Plate full_of_surfaces() {
  Plate plate = test::bare_plate(48, 40);
  plate.cracks.push_back({{0.0, 6e-3}, {9e-3, 11e-3}, Born::broken});
  plate.cutouts.push_back({Ellipse{{14e-3, 11e-3}, {3e-3, 4e-3}, 0.0}, ""});
  return plate;
}

// Returns kinetic and strain energy after many steps at a share of the limit, relative to the
// start; at rest in the end where it has diverged by orders of magnitude.
double growth_with(const Plate& plate, Numerics numerics, double share) {
  numerics.step = share * Lattice(plate, numerics).step_limit;
  numerics.force_step = true;
  Simulation simulation(plate, numerics, {1});
  simulation.restore(test::shaken(simulation.state(), 1e-9, 1));
  const double start = energy(simulation).kinetic;
  for (int n = 0; n < 1000; ++n) simulation.step();
  const Energy end = energy(simulation);
  return (end.kinetic + end.strain) / start;
}

// The limit is a bound, not exact: nodes are stiffened by less than twice, and lack bonds. Beyond
// what an edge of twice the stiffness could bear it must blow up.
TEST(Surfaces, AreStableAtTheStepLimit) {
  for (const Surface surface : {Surface::volume, Surface::energy})
    for (const double m : {2.0, 3.0, 4.0}) {
      const Numerics numerics = stiffened(surface, m);
      EXPECT_LT(growth_with(full_of_surfaces(), numerics, 0.98), 30.0) << m;
      const double grown = growth_with(full_of_surfaces(), numerics, 1.5);
      EXPECT_TRUE(!std::isfinite(grown) || grown > 1e6) << m << ": " << grown;
    }
}

TEST(Surfaces, BreakTheBondsOfTheReference) {
  for (const Surface surface : {Surface::volume, Surface::energy}) {
    Plate plate = full_of_surfaces();
    plate.material.alpha = surface == Surface::volume ? 0.25 : 0.0;
    plate.loads.tractions.push_back({Edge::right, {40e6, 0.0}});
    plate.loads.tractions.push_back({Edge::left, {-40e6, 0.0}});
    Simulation simulation(plate, stiffened(surface), {1});
    test::Reference reference(simulation);
    for (int n = 0; n < 60; ++n) {
      reference.step();
      simulation.step();
    }
    EXPECT_EQ(reference.differing_bonds(simulation), 0);
    EXPECT_GT(simulation.lattice().bonds.count() - simulation.state().bonds.count(), 100);
  }
}

// Momentum to the rounding of 1920 nodes in 500 steps; a crack at rest weighs nothing.
TEST(Surfaces, ConserveMomentumAndEnergy) {
  Simulation simulation(full_of_surfaces(), stiffened(Surface::energy), {1});
  State state = test::thrown(
      simulation, [](const Vec2& x) { return Vec2(1e-3 - 1e-4 * x.y(), 2e-3 + 1e-4 * x.x()); });
  simulation.restore(test::shaken(std::move(state), 1e-5, 3));
  const auto momentum_of = [&] {
    const Grid& grid = simulation.lattice().grid;
    Vec2 sum(0, 0);
    double turn = 0.0;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const State& now = simulation.state();
        const Vec2 x = grid.from_centre(i, j) + now.origin + now.u(i, j), v = now.v(i, j);
        if (simulation.lattice().is_void(i, j)) continue;
        sum += v;
        turn += x.x() * v.y() - x.y() * v.x();
      }
    return Eigen::Vector3d(sum.x(), sum.y(), turn);
  };
  const Eigen::Vector3d before = momentum_of();
  const Energy start = energy(simulation);
  for (int n = 0; n < 500; ++n) simulation.step();
  ASSERT_EQ(simulation.state().bonds, simulation.lattice().bonds) << "the test must stay elastic";
  const Eigen::Vector3d after = momentum_of();
  EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-11 * before.cwiseAbs().maxCoeff());
  const Energy end = energy(simulation);
  EXPECT_NEAR((end.kinetic + end.strain) / (start.kinetic + start.strain), 1.0, 1e-3);
}

// The residual of a sudden load without breaking is of second order in the step.
TEST(Surfaces, CloseTheLedger) {
  const auto residual_at = [](double share) {
    Plate plate = full_of_surfaces();
    plate.loads.tractions.push_back({Edge::right, {1e6, 5e5}});
    Numerics numerics = stiffened(Surface::energy);
    numerics.step = share * Lattice(plate, numerics).step_limit;
    Simulation simulation(plate, numerics, {1});
    simulation.run(8e-6);
    const Energy now = energy(simulation);
    EXPECT_GT(now.strain, 0.1 * now.external);
    return std::abs(now.residual()) / now.external;
  };
  const double coarse = residual_at(0.8), fine = residual_at(0.2);
  EXPECT_LT(coarse, 3e-3);
  EXPECT_LT(fine, 0.2 * coarse);
}

TEST(Surfaces, DependOnNeitherThreadsNorInstructionSet) {
  for (const Precision precision : {Precision::f64, Precision::f32})
    for (const double fidelity : {0.0, 0.5}) {
      Numerics numerics = stiffened(Surface::energy);
      numerics.precision = precision;
      numerics.fidelity = fidelity;
      const auto hash_with = [&](const Execution& execution) {
        Simulation simulation(test::edge_crack(24e6), numerics, execution);
        for (int n = 0; n < 100; ++n) simulation.step();
        return simulation.state().hash();
      };
      const std::string hash = hash_with({1, InstructionSet::baseline});
      EXPECT_EQ(hash_with({3}), hash);
      for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512})
        if (is_supported(set)) {
          EXPECT_EQ(hash_with({2, set}), hash);
        }
    }
}

TEST(Surfaces, KeepASymmetricPlateSymmetric) {
  Simulation simulation(test::edge_crack(24e6), stiffened(Surface::energy), {2});
  simulation.run(25e-6);
  EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
  EXPECT_LT(simulation.state().bonds.count(), simulation.lattice().bonds.count() - 1000);
}

// Linearised forces stay away from stiffened nodes: the error is that of linearisation alone.
TEST(Surfaces, AreNotLinearised) {
  Numerics numerics = stiffened(Surface::energy);
  numerics.spacing *= 0.5;
  numerics.horizon *= 0.5;
  const auto solved_with = [&](double fidelity) {
    numerics.fidelity = fidelity;
    Simulation simulation(test::edge_crack(12e6), numerics, {1});
    for (int n = 0; n < 60; ++n) simulation.step();
    return simulation;
  };
  const Simulation exact = solved_with(0.0), near = solved_with(0.5);
  EXPECT_GT(near.path_counts()[static_cast<std::size_t>(Path::linear)], 100);
  EXPECT_LT(test::relative_difference(exact, near), 0.5 * exact.lattice().calibration.s0);
}

// Statics and steps know the same forces: a plate that was brought to rest does not move.
TEST(Surfaces, RestWhereTheyWereBroughtToRest) {
  Plate plate = full_of_surfaces();
  plate.loads.tractions.push_back({Edge::right, {1e6, 2e5}});
  plate.loads.supports.push_back({strip(plate, Edge::left, 2e-3)});
  Simulation simulation(plate, stiffened(Surface::energy), {1});
  simulation.relax({.tolerance = 1e-10});
  const double strain = energy(simulation).strain;
  for (int n = 0; n < 200; ++n) simulation.step();
  EXPECT_LT(energy(simulation).kinetic, 1e-12 * strain);
}

}  // namespace
}  // namespace hackle
