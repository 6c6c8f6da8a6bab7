// SPDX-License-Identifier: MIT
// Absorbing edges: what comes back, where the energy goes, and the limit of the step.
#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "lattice/touching.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

using Where = Absorber::Where;

Plate absorbing(Plate plate, Where edge = Where::all) {
  plate.loads.absorbers.push_back({edge});
  return plate;
}

// A plane Gaussian pulse in displacement, `sigma` long, which travels along `way` with speed c and
// moves along `motion`.
InitialCondition plane_pulse(const Vec2& from, const Vec2& way, const Vec2& motion, double c,
                             double sigma) {
  constexpr double size = 1e-7;
  const auto phase = [=](const Vec2& at) { return (at - from).dot(way) / sigma; };
  return {{},
          VectorField([=](const Vec2& at) -> Vec2 {
            return size * std::exp(-0.5 * phase(at) * phase(at)) * motion;
          }),
          VectorField([=](const Vec2& at) -> Vec2 {
            return size * c / sigma * phase(at) * std::exp(-0.5 * phase(at) * phase(at)) * motion;
          })};
}

double energy_left(const Simulation& simulation) {
  const Energy now = energy(simulation);
  return now.kinetic + now.strain;
}

// 100 mm long; nodes are held across the motion, so the wave stays plane. At the end the pulse has
// gone from the middle to the edge and its echo, if any, is on its way back.
double echo(bool shear, double sigma, double time) {
  Plate plate = absorbing(test::bare_plate(200, 60), Where::right);
  plate.loads.supports.push_back({{}, Support::Kind::displacement, {0.0, 0.0}, shear, !shear, {}});
  const Lattice lattice(plate, test::numerics());
  const Moduli& moduli = lattice.calibration.moduli;
  const double c = std::sqrt((shear ? moduli.C12 : moduli.C11) / lattice.rho);
  plate.initial_conditions.push_back(
      plane_pulse({0.05, 0.0}, {1, 0}, shear ? Vec2(0, 1) : Vec2(1, 0), c, sigma));
  Simulation simulation(plate, test::numerics());
  const double before = energy_left(simulation);
  simulation.run(time);
  return energy_left(simulation) / before;
}

TEST(AbsorbingEdges, SendBackUnderOnePercentOfAPlanePulse) {
  for (const double sigma : {2e-3, 6e-3, 12e-3})
    EXPECT_LT(echo(false, sigma, 15e-6), 0.01) << "longitudinal, " << sigma;
  for (const double sigma : {4e-3, 12e-3})
    EXPECT_LT(echo(true, sigma, 26e-6), 0.01) << "shear, " << sigma;
}

// A round pulse meets the edges straight in their middle and at 45 degrees in the corners.
TEST(AbsorbingEdges, LetARoundPulseOut) {
  Plate plate = absorbing(test::bare_plate(120, 120));
  plate.initial_conditions.push_back({{}, {0.0, 0.0}, VectorField([](const Vec2& at) -> Vec2 {
                                        const Vec2 way = (at - Vec2(0.03, 0.03)) / 4e-3;
                                        return std::exp(-0.5 * way.squaredNorm()) * way;
                                      })});
  Simulation simulation(plate, test::numerics());
  const double before = energy_left(simulation);
  simulation.run(30e-6);
  EXPECT_LT(energy_left(simulation), 0.01 * before);
}

// What leaves is booked as damped, and nothing else is lost.
TEST(AbsorbingEdges, TheLedgerClosesToSecondOrderInTheStep) {
  double residual[2];
  for (const int fine : {0, 1}) {
    Plate plate = absorbing(test::bare_plate(60, 40));
    plate.initial_conditions.push_back({{}, {0.0, 0.0}, VectorField([](const Vec2& at) -> Vec2 {
                                          return {std::sin(200.0 * at.x()), at.y()};
                                        })});
    Numerics numerics = test::numerics();
    numerics.step = fine == 0 ? 100e-9 : 50e-9;
    Simulation simulation(plate, numerics, {1});
    const double given = energy_left(simulation);
    simulation.run(6e-6);
    const Energy now = energy(simulation);
    EXPECT_GT(now.damped, 0.3 * given);
    residual[fine] = std::abs(now.residual()) / given;
  }
  EXPECT_LT(residual[0], 2e-2);
  EXPECT_LT(residual[1], 0.35 * residual[0]);
}

// The whole plate at one speed is a long wave: each edge takes rho c v per area.
TEST(AbsorbingEdges, BearTheImpedanceOfAPlaneWave) {
  Plate plate = absorbing(test::bare_plate(40, 40), Where::right);
  plate.loads.supports.push_back({{}, Support::Kind::velocity, {2.0, 0.0}, true, true, {}});
  plate.initial_conditions.push_back({{}, {0.0, 0.0}, {2.0, 0.0}});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(2e-6);
  const double c = std::sqrt(simulation.lattice().calibration.moduli.C11 / 2235.0);
  const double taken = 2235.0 * c * 4.0 * plate.height * simulation.time_of_step();
  EXPECT_NEAR(simulation.ledger().damped, taken, 1e-9 * taken);
}

TEST(AbsorbingEdges, AreStableAtTheLimitOfTheStep) {
  for (const double m : {2.0, 3.0, 4.0, 8.0}) {
    const Plate plate = absorbing(test::bare_plate(40, 30));
    Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
    const double free = Lattice(test::bare_plate(40, 30), numerics).step_limit;
    numerics.step = Lattice(plate, numerics).step_limit * (1.0 - 1e-9);
    EXPECT_NEAR(*numerics.step, left_by_absorber * free, 1e-6 * free);
    Simulation simulation(plate, numerics, {1});
    simulation.restore(test::shaken(simulation.state(), 1e-6, 3));
    const double before = simulation.kinetic_energy();
    for (int n = 0; n < 1000; ++n) simulation.step();
    EXPECT_LT(simulation.kinetic_energy(), 0.1 * before) << m;
    numerics.step = 1.01 * *numerics.step;
    EXPECT_THROW(Simulation(plate, numerics, {1}), Error);
  }
}

TEST(AbsorbingEdges, KeepSymmetryAndDoNotDependOnThreads) {
  Plate plate = absorbing(test::bare_plate(50, 34));
  plate.loads.tractions.push_back({Edge::top, {0.0, 3e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -3e6}});
  Simulation one(plate, test::numerics(), {1}), other(plate, test::numerics(), {3});
  one.run(20e-6);
  other.run(20e-6);
  EXPECT_EQ(one.state().hash(), other.state().hash());
  EXPECT_EQ(test::asymmetric_nodes(one, true), 0);
  EXPECT_EQ(test::asymmetric_nodes(one, false), 0);
}

TEST(AbsorbingEdges, ThatComeInARunAreBookedFromThenOn) {
  Plate plate = test::bare_plate(40, 30);
  plate.initial_conditions.push_back({{}, {0.0, 0.0}, {1.0, 0.5}});
  Numerics numerics = test::numerics();
  numerics.safety = 0.5;
  Simulation simulation(plate, numerics, {1});
  simulation.run(2e-6);
  simulation.set_loads(absorbing(plate, Where::right).loads);
  simulation.run(2e-6);
  simulation.set_loads(plate.loads);
  simulation.run(2e-6);
  const Energy now = energy(simulation);
  EXPECT_GT(now.damped, 0.1 * now.external);
  EXPECT_NEAR(now.residual(), 0.0, 1e-2 * now.external);
}

TEST(AbsorbingEdges, TakeNoPartAtRest) {
  Plate plate = test::bare_plate(40, 30);
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -1e6}});
  Simulation plain(plate, test::numerics(), {1}),
      simulation(absorbing(plate), test::numerics(), {1});
  plain.relax();
  simulation.relax();
  const double size = plain.displacement(20, 29).norm();
  EXPECT_LT((plain.displacement(20, 29) - simulation.displacement(20, 29)).norm(), 1e-9 * size);
}

TEST(AbsorbingEdges, AreRefusedWhereThereIsNoNode) {
  Plate plate = absorbing(test::bare_plate(40, 40), Where::right);
  plate.outlines.push_back({{Ellipse{{0.01, 0.01}, {6e-3, 6e-3}, 0.0}}, ""});
  try {
    const Simulation simulation(plate, test::numerics(), {1});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("absorb: there is no node"));
  }
}

}  // namespace
}  // namespace hackle
