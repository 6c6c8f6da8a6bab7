// SPDX-License-Identifier: MIT
// The ledger of slow loading: work of reactions and loads, strain, broken bonds, and what jumps
// give off, each from sums of its own.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double ramp_time = 10e-6;

Support grip(Shape region, const VectorField& value, const Amplitude& amplitude) {
  Support support;
  support.region = std::move(region);
  support.value = value;
  support.amplitude = amplitude;
  return support;
}

// An edge crack, opened by leading its top up. `shift` in m, from an edge held still.
Plate led_apart(double shift, int columns = 24, int rows = 24) {
  Plate plate = test::bare_plate(columns, rows);
  plate.cracks.push_back({{0.0, 0.5 * plate.height}, {0.3 * plate.width, 0.5 * plate.height}});
  plate.loads.supports = {grip(strip(plate, Edge::bottom, 1e-3), Vec2(0, 0), {}),
                          grip(strip(plate, Edge::top, 1e-3), Vec2(0, shift), ramp(ramp_time))};
  for (const Edge edge : {Edge::top, Edge::bottom})
    plate.no_fail.push_back(strip(plate, edge, 4e-3));
  return plate;
}

// The force of the bonds on the nodes of a strip, N/m: from bond to bond, in plain SI.
Vec2 pull_on(const Simulation& simulation, int first_row, int end_row) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  Vec2 sum(0, 0);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double w, int bit) {
        if (!simulation.state().bonds.holds(grid.layout().at(i, j), bit)) return;
        const bool here = j >= first_row && j < end_row;
        const bool there = j + b >= first_row && j + b < end_row;
        if (here == there) return;
        const Vec2 y =
            grid.dx * xi + simulation.displacement(i + a, j + b) - simulation.displacement(i, j);
        const double length = grid.dx * xi.norm(), now = y.norm();
        const double c =
            0.5 * (lattice.micromodulus_at(i, j) + lattice.micromodulus_at(i + a, j + b));
        const Vec2 force = std::pow(grid.dx, 4) * c * w * (now / length - 1.0) * (y / now);
        sum += here ? force : Vec2(-force);
      });
  return sum;
}

TEST(StaticLedger, WorkIsMeanReactionTimesMoveWhileNothingBreaks) {
  Simulation simulation(led_apart(1e-7), test::numerics(), {1});
  double work = 0.0, before = 0.0;
  const int ny = simulation.lattice().grid.ny;
  for (int k = 1; k <= 4; ++k) {
    EXPECT_EQ(simulation.load_slowly({ramp_time / 4, 1, 1e-10}).broken, 0);
    const double pull = -pull_on(simulation, ny - 2, ny).y();
    work += 0.5 * (before + pull) * 0.25e-7;
    before = pull;
    const Energy ledger = energy(simulation);
    EXPECT_NEAR(ledger.external, work, 1e-7 * work);
    EXPECT_NEAR(ledger.external, ledger.strain, 1e-5 * work);  // the strain of the plate
    EXPECT_LT(std::abs(ledger.released), 1e-8 * work);
  }
}

// What a crack that jumps gives off is an entry of its own: work does not fall while a grip pulls.
TEST(StaticLedger, WorkNeverFallsWhileAGripPullsAndJumpsAreReleased) {
  Simulation simulation(led_apart(16e-6), test::numerics(), {1});
  double last = 0.0, released = 0.0;
  std::int64_t broken = 0;
  for (int k = 0; k < 8; ++k) {
    broken += simulation.load_slowly({ramp_time / 8, 1}).broken;
    const Energy ledger = energy(simulation);
    const double noise = 1e-6 * ledger.external;  // the tolerance of rest
    EXPECT_GE(ledger.external, last - noise);
    EXPECT_GE(ledger.released, released - noise);
    // Trapezoids: forces are linear to a share of the strain, 2e-3 at the tip.
    EXPECT_LT(std::abs(ledger.residual()), 2e-3 * ledger.external);
    last = ledger.external;
    released = ledger.released;
  }
  EXPECT_GT(broken, 100);
  EXPECT_GT(released, 0.05 * last);
}

// In one increment over the jump: the work is that of the plate which has not broken yet.
TEST(StaticLedger, AnIncrementLoadsBeforeAnythingBreaks) {
  Simulation gentle(led_apart(1e-7), test::numerics(), {1}),
      rough(led_apart(20e-6), test::numerics(), {1});
  gentle.load_slowly({ramp_time, 1});
  EXPECT_GT(rough.load_slowly({ramp_time, 1}).broken, 100);
  const double factor = 20e-6 / 1e-7;
  EXPECT_NEAR(energy(rough).external / (factor * factor * energy(gentle).external), 1.0, 2e-3);
  EXPECT_LT(std::abs(energy(rough).residual()), 2e-3 * energy(rough).external);
}

// A dead load goes on working while the crack jumps.
TEST(StaticLedger, DeadLoadsWorkThroughJumps) {
  Plate plate = led_apart(0.0);
  plate.loads.supports.pop_back();
  plate.loads.tractions = {{Edge::top, {0.0, 9e6}}};
  plate.loads.tractions[0].amplitude = ramp(ramp_time);
  Simulation simulation(plate, test::numerics(), {1});
  double last = 0.0;
  for (int k = 0; k < 4; ++k) {
    const QuasistaticResult result = simulation.load_slowly({ramp_time / 4, 1});
    const Energy ledger = energy(simulation);
    EXPECT_GE(ledger.external, last);
    EXPECT_LT(std::abs(ledger.residual()), 2e-3 * ledger.external);
    last = ledger.external;
    if (!result.bears) break;
  }
  EXPECT_GT(last, 0.0);
}

TEST(StaticLedger, WhatWasDampedBeforeIsKept) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.tractions = {{Edge::right, {1e6, 0.0}}, {Edge::left, {-1e6, 0.0}}};
  plate.loads.damping = 1e5;
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(5e-6);
  const Energy before = energy(simulation);
  EXPECT_GT(before.damped, 0.01 * before.external);
  simulation.relax();
  const Energy after = energy(simulation);
  EXPECT_EQ(after.damped, before.damped);
  EXPECT_EQ(after.kinetic, 0.0);
  EXPECT_NEAR(after.residual(), before.residual(), 1e-6 * after.external);
}

// Loads that have acted in steps stay what they are: their work goes on, and motion is released.
TEST(StaticLedger, MotionThatIsTakenAwayIsReleased) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.tractions = {{Edge::right, {1e6, 0.0}}, {Edge::left, {-1e6, 0.0}}};
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(2e-6);
  const Energy before = energy(simulation);
  EXPECT_GT(before.kinetic, 0.1 * before.external);
  simulation.relax();
  const Energy after = energy(simulation);
  EXPECT_GT(after.released, 0.5 * before.kinetic);
  EXPECT_NEAR(after.residual(), before.residual(), 1e-6 * after.external);
  // A dead load on the way from 0: twice the strain energy, half of it released.
  EXPECT_NEAR(after.external / after.strain, 2.0, 1e-3);
}

TEST(StaticLedger, ADisplacedPlateGivesOffWhatTheStartGave) {
  Plate plate = test::bare_plate(40, 20);
  plate.initial_conditions.push_back(
      {rectangle({0, 0}, {0.01, 0.01}), Vec2(1e-7, 2e-7), Vec2(1.0, 0.0)});
  Simulation simulation(plate, test::numerics(), {1});
  const Energy before = energy(simulation);
  simulation.relax();
  const Energy after = energy(simulation);
  EXPECT_NEAR(after.external, before.external, 1e-12 * before.external);
  EXPECT_NEAR(after.released, before.external, 1e-3 * before.external);
  EXPECT_LT(std::abs(after.residual()), 1e-3 * before.external);
}

// Several small calls are one long one.
TEST(StaticLedger, ManyShortCallsAreOneLongOne) {
  Simulation one(led_apart(1e-7), test::numerics(), {1}),
      many(led_apart(1e-7), test::numerics(), {1});
  const double dt = one.dt(), all = 2.5 * dt;
  one.load_slowly({all, 1, 1e-10});
  for (int k = 0; k < 25; ++k) many.load_slowly({0.1 * dt, 1, 1e-10});
  EXPECT_DOUBLE_EQ(one.time(), all);
  EXPECT_NEAR(many.time(), all, 1e-14 * all * 25);
  EXPECT_EQ(one.state().step, 0);
  for (const int j : {6, 15, 23}) {
    const double up = one.displacement(12, j).y();
    EXPECT_NEAR(many.displacement(12, j).y(), up, 1e-8 * std::abs(up));
  }
  EXPECT_NEAR(one.displacement(12, 23).y(), 1e-7 * all / ramp_time, 1e-12 * 1e-7);
  EXPECT_NEAR(energy(many).external, energy(one).external, 1e-6 * energy(one).external);
}

TEST(StaticLedger, IncrementsShorterThanAStepAreLoadsOfTheirOwn) {
  Simulation simulation(led_apart(1e-7), test::numerics(), {1});
  double last = 0.0;
  for (int k = 0; k < 20; ++k) {
    simulation.load_slowly({0.05 * simulation.dt(), 1});
    EXPECT_GT(simulation.displacement(12, 23).y(), last);
    last = simulation.displacement(12, 23).y();
  }
}

// A run goes on at the moment that was reached, cut or not.
TEST(StaticLedger, ARunGoesOnFromThere) {
  const double dt = Simulation(led_apart(1e-7), test::numerics(), {1}).dt();
  std::string hash;
  for (const int pieces : {1, 4}) {
    Simulation simulation(led_apart(1e-7), test::numerics(), {1});
    simulation.load_slowly({3.3 * dt, 2});
    for (int k = 0; k < pieces; ++k) simulation.run(7.0 * dt / pieces);
    EXPECT_EQ(simulation.state().step, 7);
    EXPECT_NEAR(simulation.time(), 10.3 * dt, 1e-12 * dt);
    EXPECT_NEAR(simulation.displacement(12, 23).y(), 1e-7 * 10.3 * dt / ramp_time, 1e-9 * 1e-7);
    if (hash.empty()) hash = simulation.state().hash();
    EXPECT_EQ(simulation.state().hash(), hash);
  }
}

// A grip with a velocity goes as far as its amplitude makes in the time; where there is none, it
// stays.
TEST(StaticLedger, AVelocityMovesItsNodesByItsIntegral) {
  for (const bool function : {false, true}) {
    Plate plate = led_apart(0.0);
    Support& grip = plate.loads.supports.back();
    grip.kind = Support::Kind::velocity;
    grip.value = Vec2(0, 0.01);
    grip.amplitude = function ? Amplitude([](double t) { return std::min(1.0, t / ramp_time); }, "")
                              : ramp(ramp_time);
    Simulation simulation(plate, test::numerics(), {1});
    simulation.load_slowly({0.5 * ramp_time, 3});
    EXPECT_NEAR(simulation.displacement(12, 23).y(), 0.01 * 0.125 * ramp_time,
                1e-12 * 0.01 * ramp_time);
    const double there = simulation.displacement(12, 23).y();
    simulation.relax();
    EXPECT_EQ(simulation.displacement(12, 23).y(), there);
    simulation.load_slowly({ramp_time, 1});
    EXPECT_NEAR(simulation.displacement(12, 23).y(), 0.01 * ramp_time, 1e-3 * 0.01 * ramp_time);
    EXPECT_LT(std::abs(energy(simulation).residual()), 1e-3 * energy(simulation).external);
  }
}

// Stretched along x, compressed along y: with a history the latter makes bonds bear more.
Plate squeezed(double alpha, const Amplitude& amplitude) {
  Plate plate = test::bare_plate(20, 20);
  plate.material.G0 = 0.0;
  plate.material.s0 = 0.02;
  plate.material.alpha = alpha;
  const double w = plate.width, h = plate.height;
  const VectorField field(
      [=](const Vec2& x) { return Vec2(0.025 * (x.x() - 0.5 * w), -0.02 * (x.y() - 0.5 * h)); });
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
    plate.loads.supports.push_back(grip(strip(plate, edge, 3e-3), field, amplitude));
  return plate;
}

TEST(StaticHistory, HoldsInSlowLoadingAndAtRest) {
  const Numerics numerics = test::numerics(0.5e-3, 1.5e-3);
  for (const double alpha : {0.0, 0.5}) {
    Simulation slow(squeezed(alpha, ramp(ramp_time)), numerics, {1});
    const std::int64_t broken = slow.load_slowly({ramp_time, 4}).broken;
    Simulation still(squeezed(alpha, {}), numerics, {1});
    const RelaxResult rest = still.relax();
    still.step();
    const auto lost = still.lattice().bonds.count() - still.state().bonds.count();
    if (alpha > 0.0) {
      // s0 = 0.02 + 0.5 * 0.02, less what is of second order.
      EXPECT_EQ(broken, 0);
      EXPECT_NEAR(rest.max, 0.025 / 0.03, 1e-3);
      EXPECT_EQ(rest.beyond, 0);
      EXPECT_EQ(lost, 0);
    } else {
      EXPECT_GT(broken, 100);
      EXPECT_NEAR(rest.max, 1.25, 1e-3);
      EXPECT_EQ(lost, rest.beyond);
    }
  }
}

TEST(StaticHistory, HoldsInTheFirstStepAfterAPrescribedState) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics(0.5e-3, 1.5e-3);
    numerics.precision = precision;
    Plate plate = squeezed(0.5, {});
    plate.initial_conditions.push_back({{}, plate.loads.supports[0].value, Vec2(0, 0)});
    plate.loads.supports.clear();
    Simulation simulation(plate, numerics, {1});
    simulation.step();
    EXPECT_EQ(simulation.state().bonds.count(), simulation.lattice().bonds.count());
    State state = Simulation(squeezed(0.5, {}), numerics, {1}).state();
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i)
        state.set_u(
            i, j,
            plate.initial_conditions[0].displacement.at(simulation.lattice().grid.position(i, j)) /
                0.5e-3);
    Simulation restored(squeezed(0.5, {}), numerics, {1});
    restored.restore(state);
    restored.step();
    EXPECT_EQ(restored.state().bonds.count(), restored.lattice().bonds.count());
  }
}

Plate warmed(double change, const Amplitude& amplitude) {
  Plate plate = test::bare_plate(30, 20);
  plate.material.alphaT = 9e-6;
  plate.loads.thermal_loads.push_back({{}, ScalarField(change), amplitude});
  return plate;
}

// A free plate expands by alphaT dT and bears no stress.
TEST(StaticHeat, AFreePlateExpands) {
  Simulation simulation(warmed(20.0, ramp(ramp_time)), test::numerics(), {1});
  simulation.load_slowly({ramp_time, 2, 1e-10});
  const double strain = 9e-6 * 20.0, cold = 30 * 0.5e-3;
  const double length = (simulation.displacement(29, 7) - simulation.displacement(0, 7)).x();
  EXPECT_NEAR(length / (cold - 0.5e-3) / strain, 1.0, strain);
  const Energy ledger = energy(simulation);
  // Against what it would cost not to let it.
  Simulation held(warmed(20.0, {}), test::numerics(), {1});
  const double max = energy(held).strain;
  EXPECT_LT(ledger.strain, 1e-6 * max);
  EXPECT_LT(std::abs(ledger.residual()), strain * max);  // forces are linear to that share
}

// Held at its rim, it pushes with E alphaT dT/(1 - nu): the energy of a biaxial strain.
TEST(StaticHeat, AHeldPlateIsStressed) {
  Plate plate = warmed(20.0, ramp(ramp_time));
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
    plate.loads.supports.push_back(grip(strip(plate, edge, 0.5e-3), Vec2(0, 0), {}));
  Simulation simulation(plate, test::numerics(), {1});
  simulation.load_slowly({ramp_time, 4, 1e-10});
  const Energy ledger = energy(simulation);
  EXPECT_NEAR(ledger.external / ledger.strain, 1.0, 1e-5);
  // Half of stress times strain, twice: what half a plate of bonds lacks is at its rim.
  const Moduli& moduli = simulation.lattice().calibration.moduli;
  const double strain = 9e-6 * 20.0;
  const double full = moduli.E / (1.0 - moduli.nu) * strain * strain * plate.width * plate.height;
  EXPECT_LT(ledger.strain, full);
  EXPECT_GT(ledger.strain, 0.75 * full);
}

TEST(StaticHeat, TwoMaterialsBendAndTheLedgerCloses) {
  Plate plate = warmed(50.0, ramp(ramp_time));
  Material other = plate.material;
  other.E *= 0.5;
  other.alphaT = 3e-6;
  plate.inclusions.push_back({rectangle({0, 0}, {plate.width, 0.5 * plate.height}), other});
  plate.loads.tractions = {{Edge::right, {1e6, 0.0}}, {Edge::left, {-1e6, 0.0}}};
  Simulation simulation(plate, test::numerics(), {2});
  simulation.load_slowly({ramp_time, 3, 1e-9});
  const Energy ledger = energy(simulation);
  const double max = energy(Simulation(warmed(50.0, {}), test::numerics(), {1})).strain;
  EXPECT_LT(std::abs(ledger.residual()), 9e-6 * 50.0 * max);
  EXPECT_GT(ledger.strain, 0.0);
  for (int k = 0; k < 100; ++k) simulation.step();
  EXPECT_LT(energy(simulation).kinetic, 1e-9 * ledger.strain);
}

}  // namespace
}  // namespace hackle
