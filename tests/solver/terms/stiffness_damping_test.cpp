// SPDX-License-Identifier: MIT
// Stiffness damping against the decay of standing waves, rigid motion and the limit of the step.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Plate stiffly_damped(Plate plate, double beta) {
  plate.loads.stiffness_damping = beta;
  return plate;
}

// 100 mm of plate, which moves along x only, in `waves` half waves from end to end.
Plate standing_wave(int waves) {
  Plate plate = test::bare_plate(200, 20);
  plate.loads.supports.push_back({{}, Support::Kind::displacement, {0.0, 0.0}, false, true, {}});
  const double k = waves * std::numbers::pi / plate.width;
  plate.initial_conditions.push_back({{}, {0.0, 0.0}, VectorField([k](const Vec2& at) -> Vec2 {
                                        return {0.1 * std::cos(k * at.x()), 0.0};
                                      })});
  return plate;
}

double left_of_wave(const Simulation& simulation) {
  const Energy now = energy(simulation);
  return now.kinetic + now.strain;
}

// A wave of angular frequency w decays as exp(-beta w^2 t/2), its energy as the square. The modulus
// across is held, so c^2 = C11/rho; rows near the free edges are softer: 3 % at 20 rows.
TEST(StiffnessDamping, AStandingWaveDecaysWithTheSquareOfItsFrequency) {
  for (const auto& [waves, beta] : {std::pair{2, 4e-7}, {8, 2.5e-8}}) {
    Simulation simulation(stiffly_damped(standing_wave(waves), beta), test::numerics());
    const double c2 = simulation.lattice().calibration.moduli.C11 / 2235.0;
    const double k = waves * std::numbers::pi / 0.1, rate = beta * c2 * k * k;
    const double before = left_of_wave(simulation);
    simulation.run(1.0 / rate);
    EXPECT_NEAR(std::log(before / left_of_wave(simulation)) / (rate * simulation.time()), 1.0, 0.08)
        << waves;
  }
}

TEST(StiffnessDamping, TheLedgerClosesToSecondOrderInTheStep) {
  double residual[2];
  for (const int fine : {0, 1}) {
    Numerics numerics = test::numerics();
    numerics.step = fine == 0 ? 100e-9 : 50e-9;
    Simulation simulation(stiffly_damped(standing_wave(9), 3e-8), numerics);
    const double given = left_of_wave(simulation);
    simulation.run(10e-6);
    const Energy now = energy(simulation);
    EXPECT_GT(now.damped, 0.3 * given);
    residual[fine] = std::abs(now.residual()) / given;
  }
  EXPECT_LT(residual[0], 1e-2);
  EXPECT_LT(residual[1], 0.35 * residual[0]);
}

// Translation makes no force at all, and neither do the parts of a plate that has been cut in two.
TEST(StiffnessDamping, LeavesPiecesThatMoveAsOneAlone) {
  Plate plate = test::bare_plate(40, 20);
  plate.cracks.push_back(Crack({0.0, 5e-3}, {20e-3, 5e-3}));
  plate.initial_conditions.push_back({{}, {0.0, 0.0}, VectorField([](const Vec2& at) -> Vec2 {
                                        return at.y() > 5e-3 ? Vec2(3.0, 4.0) : Vec2(-2.0, -1.0);
                                      })});
  Simulation free(plate, test::numerics(), {1});
  Numerics same = test::numerics();
  same.step = free.dt();
  same.force_step = true;
  Simulation damped(stiffly_damped(plate, 1e-8), same, {1});
  free.run(20e-6);
  damped.run(20e-6);
  EXPECT_EQ(free.state().hash(), damped.state().hash());
  EXPECT_EQ(damped.ledger().damped, 0.0);
}

// A plate that turns by a tenth in every step as one: bonds keep their lengths, so nothing damps.
TEST(StiffnessDamping, LeavesARigidRotationAloneHoweverFast) {
  Simulation simulation(stiffly_damped(test::bare_plate(20, 10), 1e-8), test::numerics(), {1});
  const auto turned = [](double angle, const Vec2& x) -> Vec2 {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x.x() - s * x.y(), s * x.x() + c * x.y()};
  };
  State state =
      test::displaced(simulation, [&](const Vec2& x) -> Vec2 { return turned(0.2, x) - x; });
  const Grid& grid = simulation.lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      state.set_v(i, j, turned(0.2, grid.from_centre(i, j)) - turned(0.1, grid.from_centre(i, j)));
  state.step = 1;
  simulation.restore(state);
  const double unit = simulation.dt() * simulation.dt() / grid.dx;
  for (const LoadedNode& node : simulation.actions().forces)
    EXPECT_LT(unit * node.acceleration.norm(), 1e-13);
}

TEST(StiffnessDamping, KeepsBothMomenta) {
  Simulation simulation(stiffly_damped(test::bare_plate(30, 20), 2e-8), test::numerics(), {2});
  simulation.restore(test::shaken(simulation.state(), 1e-4, 7));
  const auto momenta = [&] {
    const Grid& grid = simulation.lattice().grid;
    Vec2 linear(0, 0);
    double angular = 0.0;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const Vec2 x = grid.from_centre(i, j) + simulation.state().u(i, j),
                   v = simulation.state().v(i, j);
        linear += v;
        angular += x.x() * v.y() - x.y() * v.x();
      }
    return std::pair{linear, angular};
  };
  simulation.step();  // until v is half a step behind u
  const auto [linear, angular] = momenta();
  for (int n = 0; n < 300; ++n) simulation.step();
  const auto [linear_after, angular_after] = momenta();
  EXPECT_GT(simulation.ledger().damped, 0.0);
  EXPECT_LT((linear_after - linear).norm(), 1e-14);
  EXPECT_NEAR(angular_after, angular, 1e-12);
}

// omega dt/2 = sqrt(1 + zeta^2) - zeta, zeta = beta omega/2 (src/lattice/README.md 4.7).
TEST(StiffnessDamping, LimitsTheStep) {
  const double free = Lattice(test::bare_plate(30, 20), test::numerics()).step_limit;
  const double omega = 2.0 / free, beta = 0.8 / omega;  // zeta 0.4
  const Plate plate = stiffly_damped(test::bare_plate(30, 20), beta);
  const double limit = Lattice(plate, test::numerics()).step_limit;
  EXPECT_NEAR(limit, free * (std::sqrt(1.16) - 0.4), 1e-9 * free);
  Numerics numerics = test::numerics();
  numerics.step = 0.999 * limit;
  Simulation simulation(plate, numerics, {1});
  simulation.restore(test::shaken(simulation.state(), 1e-6, 3));
  const double before = simulation.kinetic_energy();
  for (int n = 0; n < 1000; ++n) simulation.step();
  EXPECT_LT(simulation.kinetic_energy(), before);
  numerics.step = 1.1 * limit;
  EXPECT_THROW(Simulation(plate, numerics, {1}), Error);
  numerics.force_step = true;
  Simulation unstable(plate, numerics, {1});
  unstable.restore(test::shaken(unstable.state(), 1e-9, 3));
  for (int n = 0; n < 200; ++n) unstable.step();
  EXPECT_GT(unstable.kinetic_energy(), before);  // from a millionth of it
  Simulation undamped(test::bare_plate(30, 20), test::numerics(), {1});
  try {
    undamped.set_loads(plate.loads);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("damping: the step is"));
  }
}

TEST(StiffnessDamping, KeepsSymmetryAndDoesNotDependOnThreads) {
  Plate plate = stiffly_damped(test::bare_plate(50, 34), 1e-8);
  plate.loads.tractions.push_back({Edge::top, {0.0, 30e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -30e6}});
  plate.cracks.push_back(Crack({8e-3, 8.5e-3}, {17e-3, 8.5e-3}));
  Simulation one(plate, test::numerics(), {1}), other(plate, test::numerics(), {3});
  one.run(15e-6);
  other.run(15e-6);
  EXPECT_LT(one.state().bonds.count(), one.lattice().bonds.count());
  EXPECT_EQ(one.state().hash(), other.state().hash());
  EXPECT_EQ(test::asymmetric_nodes(one, true), 0);
  EXPECT_EQ(test::asymmetric_nodes(one, false), 0);
}

}  // namespace
}  // namespace hackle
