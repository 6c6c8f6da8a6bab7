// SPDX-License-Identifier: MIT
#include "solver/statics/static_equilibrium.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Plate pulled(int columns, int rows, double stress = 1e6) {
  Plate plate = test::bare_plate(columns, rows);
  plate.loads.tractions = {{Edge::right, {stress, 0.0}}, {Edge::left, {-stress, 0.0}}};
  return plate;
}

Support prescribed(Shape region, VectorField value) {
  Support support;
  support.region = std::move(region);
  support.value = std::move(value);
  return support;
}

// Far from the left and right edges; a node nearer to top or bottom than a horizon is softer.
TEST(StaticEquilibrium, AUniformStrainLedOnTheRimFillsThePlateWithTheModulusOfTheLattice) {
  constexpr double strain = 1e-7;  // forces are linear to a share of this size
  Plate plate = test::bare_plate(50, 40);
  const double nu =
      Lattice(plate, test::numerics()).calibration.moduli.nu;  // so that the stress is uniaxial
  const VectorField field(
      [=](const Vec2& x) { return Vec2(strain * x.x(), -nu * strain * x.y()); });
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
    plate.loads.supports.push_back(prescribed(strip(plate, edge, 4e-3), field));
  Simulation simulation(plate, test::numerics(), {1});
  simulation.relax({1e-10, {}});

  const Grid& grid = simulation.lattice().grid;
  const Calibration& calibration = simulation.lattice().calibration;
  double worst = 0.0, worst_modulus = 0.0;
  for (int j = 8; j < grid.ny - 8; ++j)
    for (int i = 8; i < grid.nx - 8; ++i) {
      const Vec2 u = simulation.displacement(i, j);
      worst = std::max(worst, (u - field.at(grid.position(i, j))).norm());
      double density = 0.0;  // 1/4 c V sum w s^2 |xi| over all bonds, twice that over those kept
      simulation.lattice().family.for_each_bond([&](int a, int b, const Vec2& xi, double w, int) {
        const Vec2 h = simulation.displacement(i + a, j + b) - u;
        const double s = h.dot(h + 2.0 * grid.dx * xi) / (2.0 * (grid.dx * xi).squaredNorm());
        density += 0.5 * calibration.c * std::pow(grid.dx, 3) * w * s * s * xi.norm();
      });
      const double modulus = 2.0 * density / (strain * strain);
      worst_modulus = std::max(worst_modulus, std::abs(modulus / calibration.moduli.E - 1.0));
    }
  EXPECT_LT(worst, 1e-6 * strain * plate.width);
  EXPECT_LT(worst_modulus, 1e-6);
}

// What is left of the force, 1e-8 of the loads, makes waves of 1e-16 of the strain energy.
TEST(StaticEquilibrium, TheDynamicSolverStaysThere) {
  Plate plate = pulled(60, 40);
  plate.cracks.push_back({{0.0, 0.5 * plate.height}, {0.3 * plate.width, 0.6 * plate.height}});
  for (const double first : {0.0, 2e-6}) {
    Simulation simulation(plate, test::numerics(), {1});
    simulation.run(first);
    const std::int64_t step = simulation.state().step;
    const Energy before = energy(simulation);
    const RelaxResult result = simulation.relax();
    EXPECT_LE(result.residual, 1e-8);
    EXPECT_EQ(result.beyond, 0);
    EXPECT_GT(result.max, 0.0);
    EXPECT_LT(result.max, 1.0);
    EXPECT_EQ(simulation.state().step, step);
    // Loaded slowly where it stood; what has acted in steps gives off as much as it stores.
    const Energy rest = energy(simulation);
    EXPECT_NEAR(rest.residual(), before.residual(), 1e-5 * rest.external);
    EXPECT_NEAR(rest.external, (first > 0.0 ? 2.0 : 1.0) * rest.strain, 1e-3 * rest.strain);
    for (int k = 0; k < 200; ++k) simulation.step();
    const Energy later = energy(simulation);
    EXPECT_LT(later.kinetic, 1e-12 * later.strain);
    EXPECT_NEAR(later.residual(), rest.residual(), 1e-12 * later.strain);
  }
}

// A step from rest is half a kick: after a whole one the plate would move at once. It is the same
// motion whenever it begins.
TEST(StaticEquilibrium, WhatFollowsDoesNotDependOnTheStepAtWhichItBegins) {
  Plate calm = pulled(40, 20);
  Loads other = calm.loads;
  other.tractions[0].stress = {2e6, 0.0};
  other.tractions[1].stress = {-2e6, 0.0};
  Simulation early(calm, test::numerics(), {1}), late(calm, test::numerics(), {1});
  late.run(1e-6);
  for (Simulation* simulation : {&early, &late}) {
    simulation->relax();
    simulation->set_loads(other);
    simulation->run(2e-6);
  }
  double max = 0.0, difference = 0.0;
  for (int i = 0; i < 40; ++i) {
    max = std::max(max, early.displacement(i, 7).norm());
    difference = std::max(difference, (early.displacement(i, 7) - late.displacement(i, 7)).norm());
  }
  EXPECT_LT(difference, 1e-6 * max);  // 1e-8 of the loads, times what waves make of it
}

TEST(StaticEquilibrium, AFreePlateKeepsItsPlace) {
  Simulation simulation(pulled(40, 21), test::numerics(), {1});
  State state = simulation.state();
  for (int j = 0; j < 21; ++j)
    for (int i = 0; i < 40; ++i) state.set_u(i, j, {0.25, -0.5});
  simulation.restore(state);
  simulation.relax();
  Vec2 mean(0, 0);
  for (int j = 0; j < 21; ++j)
    for (int i = 0; i < 40; ++i) mean += simulation.displacement(i, j) / (40 * 21 * 0.5e-3);
  EXPECT_NEAR(mean.x(), 0.25, 1e-12);
  EXPECT_NEAR(mean.y(), -0.5, 1e-12);
}

// Pulled at two corners across, it turns until the forces are in line.
TEST(StaticEquilibrium, AFreePlateTurnsUntilItsLoadsHaveNoMoment) {
  Plate plate = test::bare_plate(40, 20);
  const double w = plate.width, h = plate.height;
  const Vec2 force(0.75 * w * 1e11, 0.5 * h * 1e11);  // N/m3, through the centres of the two areas
  plate.loads.body_forces = {
      {rectangle({0.75 * w, 0.5 * h}, {w, h}), VectorField(force), {}},
      {rectangle({0, 0}, {0.25 * w, 0.5 * h}), VectorField(Vec2(-force)), {}}};
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_LE(simulation.relax().residual, 1e-8);
  for (int k = 0; k < 100; ++k) simulation.step();
  EXPECT_LT(energy(simulation).kinetic, 1e-12 * energy(simulation).strain);
}

std::string refusal(Simulation& simulation) {
  const std::string before = simulation.state().hash();
  try {
    simulation.relax();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_EQ(simulation.state().hash(), before);
    return error.what();
  }
  return "";
}

TEST(StaticEquilibrium, RefusesAFreePlateThatIsPushed) {
  Plate plate = pulled(40, 20);
  plate.loads.tractions.pop_back();
  Simulation simulation(plate, test::numerics(), {1});
  // 1 MPa on 10 mm.
  EXPECT_THAT(refusal(simulation),
              testing::HasSubstr("the fragment of 800 nodes around (10 mm, 5 mm) "
                                 "with (1e+04 N/m, 0 N/m)"));
}

TEST(StaticEquilibrium, RefusesAFreePlateThatIsTurned) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.tractions = {{Edge::right, {0.0, 1e6}}, {Edge::left, {0.0, -1e6}}};
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_THAT(refusal(simulation), testing::HasSubstr("nothing holds it"));
}

TEST(StaticEquilibrium, RefusesALoadToWhichTheSupportsGiveWay) {
  Plate plate = pulled(40, 20);
  plate.loads.tractions.pop_back();
  Support support = prescribed(strip(plate, Edge::bottom, 2e-3), Vec2(0, 0));
  support.along_x = false;
  plate.loads.supports.push_back(support);
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_THAT(refusal(simulation), testing::HasSubstr("its supports give way"));
}

// One node holds it; the loads make a couple.
TEST(StaticEquilibrium, RefusesALoadThatTurnsAPlateOnItsHinge) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.tractions = {{Edge::right, {0.0, 1e6}}, {Edge::left, {0.0, -1e6}}};
  plate.loads.supports = {prescribed(rectangle({10e-3, 5e-3}, {10.5e-3, 5.5e-3}), Vec2(0, 0))};
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_THAT(refusal(simulation), testing::HasSubstr("relax: the loads push"));
  EXPECT_THAT(refusal(simulation), testing::HasSubstr("its supports give way"));
}

TEST(StaticEquilibrium, RefusesOnlyTheFragmentThatIsPushed) {
  Plate plate = test::bare_plate(40, 20);
  plate.cracks.push_back({{0.25 * plate.width, 0.0}, {0.25 * plate.width, plate.height}});
  plate.loads.tractions = {{Edge::right, {1e6, 0.0}}};
  plate.loads.supports = {prescribed(strip(plate, Edge::left, 1e-3), Vec2(0, 0))};
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_THAT(refusal(simulation), testing::HasSubstr("the fragment of 600 nodes around (12.5 mm"));
}

TEST(StaticEquilibrium, ABarOnRollersContractsAcross) {
  Plate plate = test::bare_plate(60, 20);
  Support roller = prescribed(strip(plate, Edge::left, 0.5e-3), Vec2(0, 0));
  roller.along_y = false;
  plate.loads.supports = {roller};
  plate.loads.tractions = {{Edge::right, {1e6, 0.0}}};
  Simulation simulation(plate, test::numerics(), {1});
  simulation.relax();
  EXPECT_LT(simulation.displacement(30, 19).y(), simulation.displacement(30, 0).y());
  EXPECT_EQ(simulation.displacement(0, 9).x(), 0.0);
}

// Supports are where they are to be at the time of the state.
TEST(StaticEquilibrium, PrescribedNodesAreWhereTheAmplitudeHasThem) {
  Plate plate = test::bare_plate(30, 20);
  Support right = prescribed(strip(plate, Edge::right, 1e-3), Vec2(1e-5, 0));
  right.amplitude = ramp(10e-6);
  plate.loads.supports = {prescribed(strip(plate, Edge::left, 1e-3), Vec2(0, 0)), right};
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(2e-6);
  const double now = 1e-5 * simulation.time() / 10e-6;
  simulation.relax();
  EXPECT_NEAR(simulation.displacement(29, 3).x(), now, 1e-12 * 1e-5);
  EXPECT_NEAR(simulation.displacement(0, 3).x(), 0.0, 1e-20);
  EXPECT_NEAR(simulation.displacement(15, 10).x(), 0.5 * now, 0.05 * now);
  const Energy ledger = energy(simulation);
  EXPECT_LT(std::abs(ledger.residual()), 0.01 * ledger.external);  // of the run before
}

TEST(StaticEquilibrium, StiffnessesOfTwoMaterialsAreInSeries) {
  Plate plate = pulled(80, 21);
  Material soft = plate.material;
  soft.E *= 0.25;
  plate.inclusions.push_back({rectangle({0, 0}, {0.5 * plate.width, plate.height}), soft});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.relax();
  const auto strain = [&](int i, int k) {
    return (simulation.displacement(k, 10).x() - simulation.displacement(i, 10).x()) /
           ((k - i) * 0.5e-3);
  };
  // The same stress on either side, on the axis two horizons from ends and joint; what the joint
  // does to it in a plate 5 horizons wide falls with the distance over the width.
  EXPECT_NEAR(strain(16, 24) / strain(56, 64), 4.0, 0.1);
}

TEST(StaticEquilibrium, VoidNodesAndNodesWithoutBondsStay) {
  Plate plate = pulled(40, 40);
  plate.cutouts.push_back({Ellipse{{0.01, 0.01}, {3e-3, 3e-3}, 0.0}, ""});
  Simulation simulation(plate, test::numerics(), {1});
  State state = simulation.state();
  for (const int i : {0, 39})  // both are loaded: the rest stays in balance
    isolate(simulation.lattice().grid, simulation.lattice().family, i, 20, state.bonds);
  simulation.restore(state);
  EXPECT_LE(simulation.relax().residual, 1e-8);
  EXPECT_EQ(simulation.displacement(39, 20), Vec2(0, 0));
  EXPECT_EQ(simulation.displacement(20, 20), Vec2(0, 0));
  EXPECT_GT(simulation.displacement(39, 19).x(), 0.0);
}

TEST(StaticEquilibrium, BitsDependNeitherOnThreadsNorOnTheSideOfTheMirror) {
  Plate plate = test::edge_crack(6e6);
  plate.width = 0.03;
  plate.height = 0.02;
  plate.no_fail.clear();
  plate.cracks = {{{0.01, 0.01}, {0.02, 0.01}}};
  std::string hash;
  for (const int threads : {1, 2, 5}) {
    Simulation simulation(plate, test::numerics(), {threads});
    simulation.relax();
    if (hash.empty()) hash = simulation.state().hash();
    EXPECT_EQ(simulation.state().hash(), hash) << threads;
    EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
    EXPECT_EQ(test::asymmetric_nodes(simulation, false), 0);
  }
}

// Rounding u to f32 moves it by 6e-8 of itself.
TEST(StaticEquilibrium, SinglePrecisionRestsAtTheSamePlace) {
  Numerics numerics = test::numerics();
  Simulation exact(pulled(60, 40), numerics, {1});
  exact.relax();
  numerics.precision = Precision::f32;
  Simulation rounded(pulled(60, 40), numerics, {1});
  rounded.relax();
  EXPECT_EQ(rounded.state().precision(), Precision::f32);
  const double max = exact.displacement(59, 20).norm();
  for (int i = 0; i < 60; ++i)
    EXPECT_LT((exact.displacement(i, 11) - rounded.displacement(i, 11)).norm(), 1e-7 * max);
}

TEST(StaticEquilibrium, SaysWhatIsStretchedTooFarAndBreaksNothing) {
  Plate plate = pulled(40, 20, 40e6);
  Simulation simulation(plate, test::numerics(), {1});
  const RelaxResult result = simulation.relax();
  EXPECT_GT(result.max, 1.0);
  EXPECT_GT(result.beyond, 0);
  EXPECT_EQ(simulation.state().bonds.count(), simulation.lattice().bonds.count());
  simulation.step();
  EXPECT_EQ(simulation.state().bonds.count(), simulation.lattice().bonds.count() - result.beyond);
}

// Crumbs that are led move, and nothing else is there to be found.
TEST(StaticEquilibrium, APlateWithoutABondIsLedAllTheSame) {
  Plate plate = test::bare_plate(12, 8);
  plate.loads.supports = {prescribed(strip(plate, Edge::right, 1e-3), Vec2(1e-6, 0))};
  Simulation simulation(plate, test::numerics(), {1});
  State state = simulation.state();
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 12; ++i)
      isolate(simulation.lattice().grid, simulation.lattice().family, i, j, state.bonds);
  simulation.restore(state);
  simulation.relax();
  EXPECT_NEAR(simulation.displacement(11, 3).x(), 1e-6, 1e-18);
  EXPECT_EQ(simulation.displacement(5, 3), Vec2(0, 0));
}

TEST(StaticEquilibrium, AnUntouchedPlateTakesNoStep) {
  Simulation simulation(test::bare_plate(20, 10), test::numerics(), {1});
  EXPECT_EQ(simulation.relax().iterations, 0);
}

TEST(StaticEquilibrium, WavesInAPlateWithoutLoadsComeToRest) {
  Plate plate = test::bare_plate(40, 20);
  plate.initial_conditions.push_back(
      {rectangle({0, 0}, {0.01, 0.01}), Vec2(1e-7, 2e-7), Vec2(1.0, 0.0)});
  Simulation simulation(plate, test::numerics(), {1});
  const double before = energy(simulation).strain;
  simulation.relax();
  EXPECT_EQ(energy(simulation).kinetic, 0.0);
  EXPECT_LT(energy(simulation).strain, 1e-12 * before);
}

TEST(StaticEquilibrium, AnInterruptChangesNothing) {
  Simulation simulation(pulled(40, 20), test::numerics(), {1});
  const std::string before = simulation.state().hash();
  request_interrupt();
  try {
    simulation.relax();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
  clear_interrupt();
  EXPECT_EQ(simulation.state().hash(), before);
  EXPECT_GT(simulation.relax().iterations, 0);
}

TEST(StaticEquilibrium, RefusesAToleranceOutsideItsRange) {
  Simulation simulation(pulled(40, 20), test::numerics(), {1});
  for (const double bad : {0.0, -1.0, 1.0, std::nan("")})
    EXPECT_THROW(simulation.relax({bad, {}}), Error) << bad;
}

// Ten times what a plate of rubber bears in compression: it would fold.
TEST(StaticEquilibrium, EndsWithAnErrorWhereThereIsNoEquilibrium) {
  Plate plate = pulled(200, 6, -1e9);
  plate.material.E = 1e9;
  Simulation simulation(plate, test::numerics(), {1});
  const std::string before = simulation.state().hash();
  try {
    simulation.relax();
    EXPECT_GT(energy(simulation).strain, 0.0);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::run_failed) << error.what();
    EXPECT_EQ(simulation.state().hash(), before);
  }
}

TEST(StaticEquilibrium, TellsHowFarItHasCome) {
  Simulation simulation(pulled(40, 20), test::numerics(), {1});
  double last = 0.0;
  int calls = 0;
  simulation.relax({1e-8, [&](double fraction, int iterations) {
                      EXPECT_GE(fraction, 0.0);
                      EXPECT_LE(fraction, 1.0);
                      EXPECT_EQ(iterations, ++calls);
                      last = fraction;
                    }});
  EXPECT_GT(calls, 10);
  EXPECT_GT(last, 0.9);
}

}  // namespace
}  // namespace hackle
