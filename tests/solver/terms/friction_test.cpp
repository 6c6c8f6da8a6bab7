// SPDX-License-Identifier: MIT
// Friction and restitution where fragments, faces, discs, rollers and platens press, against
// sliding blocks and rebounds from a rigid plate.
#include <cmath>

#include <gmock/gmock.h>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "solver/terms/roughness.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

TEST(Roughness, TakesEnergyAndNeverGivesIt) {
  const Vec2 force(0.0, 2.0);
  const Vec2 sliding = loss_of({0.5, 1.0}, force, {3.0, 0.0}, 10.0);
  EXPECT_EQ(sliding, Vec2(-1.0, 0.0));
  EXPECT_EQ(loss_of({0.5, 1.0}, force, {3.0, 0.0}, 0.1), Vec2(-0.1 * 3.0, 0.0));  // it sticks
  EXPECT_EQ(loss_of({0.0, 0.6}, force, {0.0, -1.0}, 1.0), Vec2(0.0, 0.0));        // it comes
  EXPECT_LT((loss_of({0.0, 0.6}, force, {0.0, 1.0}, 1.0) - Vec2(0.0, -0.64 * 2.0)).norm(), 1e-15);
  for (int k = 0; k < 64; ++k) {
    const Vec2 velocity(std::cos(0.1 * k), std::sin(0.1 * k));
    EXPECT_LE(loss_of({0.7, 0.3}, force, velocity, 0.5).dot(velocity), 0.0) << k;
  }
}

// A disc thrown straight at a plate that cannot move goes back with `restitution` of its speed.
TEST(Roughness, ADiscReboundsWithTheGivenShareOfItsSpeed) {
  for (const double e : {1.0, 0.7, 0.3, 0.0}) {
    Plate plate = test::bare_plate(40, 20);
    plate.loads.supports.push_back({{}, Support::Kind::velocity, {0.0, 0.0}, true, true, {}});
    plate.loads.impactors.push_back({{10e-3, 14.01e-3}, 4e-3, {0.0, -20.0}, 0.5, 0.0, e});
    Numerics numerics = test::numerics();
    numerics.safety = 0.2;
    Simulation simulation(plate, numerics, {1});
    simulation.run(40e-6);
    const double speed = simulation.state().discs.front().velocity.y() *
                         (simulation.lattice().grid.dx / simulation.dt());
    EXPECT_NEAR(speed, 20.0 * e, 0.02 * 20.0) << e;
  }
}

// A block on a held platen, under a body force f: whatever it bounces, the platen takes mu times
// the momentum across that it takes along. So rho dv_x = -mu (f t + rho dv_y).
TEST(Roughness, ASlidingBlockIsSlowedByFrictionTimesItsWeight) {
  for (const double mu : {0.0, 0.2, 0.5}) {
    Plate plate = test::bare_plate(40, 20);
    plate.loads.platens.push_back(
        {{-0.02, -0.005}, {0.06, 0.0}, Guide::displacement, {0, 0}, {}, mu});
    plate.loads.body_forces.push_back({{}, {0.0, -2235.0 * 2e5}, {}});
    plate.initial_conditions.push_back({{}, {0.0, 0.0}, {20.0, 0.0}});
    plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.02, 0.01}));
    Simulation simulation(plate, test::numerics(), {1});
    simulation.run(40e-6);
    Vec2 v(0, 0);
    for (const Vec2& one : simulation.velocities()) v += one / 800.0;
    const double pressed = 2e5 * simulation.time() + v.y();
    EXPECT_GT(pressed, 2.0);
    EXPECT_NEAR(20.0 - v.x(), mu * pressed, 0.02 * pressed) << mu;
    EXPECT_NEAR(energy(simulation).residual(), 0.0, 0.02 * energy(simulation).kinetic);
  }
}

// Two halves of a plate with a crack between that both slide along it, pressed together by body
// forces: the momentum of both is kept to rounding, what they lose is damped. They slide by less
// than a hundredth of a spacing, where lost bonds resist by a ninth of what presses even without
// friction (src/solver/README.md 7.1); friction comes on top.
TEST(Roughness, FacesOfACrackResistSliding) {
  double slowed[2];
  for (const int rough : {0, 1}) {
    Plate plate = test::bare_plate(60, 24);
    plate.cracks.push_back(Crack({0.0, 6e-3}, {30e-3, 6e-3}, Born::absent));
    plate.contact = Contact{};
    plate.contact->friction = 0.4 * rough;
    plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.03, 0.012}));
    const double f = 2235.0 * 5e4;
    plate.loads.body_forces.push_back({rectangle({0.0, 6e-3}, {0.03, 0.012}), {0.0, -f}, {}});
    plate.loads.body_forces.push_back({rectangle({0.0, 0.0}, {0.03, 6e-3}), {0.0, f}, {}});
    plate.initial_conditions.push_back({{}, {0.0, 0.0}, VectorField([](const Vec2& at) -> Vec2 {
                                          return {at.y() > 6e-3 ? 0.5 : -0.5, 0.0};
                                        })});
    Simulation simulation(plate, test::numerics(), {2});
    simulation.run(2e-6);
    Vec2 momentum(0, 0), upper(0, 0);
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 60; ++i) {
        const Vec2 v = simulation.state().v(i, j) * (0.5e-3 / simulation.dt());
        momentum += v;
        if (j >= 12) upper += v / 720.0;
      }
    EXPECT_LT(momentum.norm(), 1e-6);
    slowed[rough] = 0.5 - upper.x();
    const double pressed = 5e4 * simulation.time() + upper.y();
    EXPECT_GT(pressed, 0.05);
    EXPECT_NEAR(slowed[rough] - rough * slowed[0], 0.4 * rough * pressed,
                0.12 * pressed / (1 + 2 * rough))
        << rough;
    const Energy now = energy(simulation);
    EXPECT_EQ(now.damped > 0.0, rough == 1);
    EXPECT_GE(now.damped, 0.0);
    EXPECT_NEAR(now.residual(), 0.0, 0.02 * now.kinetic);
  }
}

// Faces that are pressed together and can hardly slide, at the longest step that is allowed.
TEST(Roughness, IsStableAtTheLimitOfTheStep) {
  Plate plate = test::bare_plate(40, 24);
  plate.cracks.push_back(Crack({0.0, 6e-3}, {20e-3, 6e-3}, Born::absent));
  plate.contact = Contact{15.0, 0.9, 10.0, 1.0};
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.02, 0.012}));
  plate.loads.tractions = {{Edge::top, {0.0, -50e6}, 6e-3}, {Edge::bottom, {0.0, 50e6}, 6e-3}};
  Numerics numerics = test::numerics();
  numerics.step = Lattice(plate, numerics).step_limit * (1.0 - 1e-9);
  Simulation simulation(plate, numerics, {1});
  simulation.restore(test::shaken(simulation.state(), 1e-4, 5));
  const double before = simulation.kinetic_energy();
  double max = 0.0;
  for (int n = 0; n < 1500; ++n) {
    simulation.step();
    if (n % 50 == 0) max = std::max(max, simulation.kinetic_energy());
  }
  EXPECT_LT(max, 2.0 * (before + simulation.ledger().external));
  EXPECT_GT(simulation.ledger().damped, 0.0);
}

TEST(Roughness, KeepsSymmetryAndDoesNotDependOnThreads) {
  Plate plate = test::bare_plate(50, 34);
  plate.contact = Contact{};
  plate.contact->friction = 0.3;
  plate.contact->restitution = 0.5;
  plate.cracks.push_back(Crack({0.0, 8.5e-3}, {25e-3, 8.5e-3}));
  const Vec2 still(0.0, 0.0);
  plate.initial_conditions = {{rectangle({0.0, 0.0}, {12.5e-3, 17e-3}), still, {-10.0, 0.0}},
                              {rectangle({12.5e-3, 0.0}, {25e-3, 17e-3}), still, {10.0, 0.0}},
                              {rectangle({0.0, 0.0}, {25e-3, 8.5e-3}), still, {0.0, 5.0}},
                              {rectangle({0.0, 8.5e-3}, {25e-3, 17e-3}), still, {0.0, -5.0}}};
  Simulation one(plate, test::numerics(), {1}), other(plate, test::numerics(), {3});
  one.run(15e-6);
  other.run(15e-6);
  EXPECT_EQ(one.state().hash(), other.state().hash());
  EXPECT_EQ(test::asymmetric_nodes(one, true), 0);
  EXPECT_EQ(test::asymmetric_nodes(one, false), 0);
}

}  // namespace
}  // namespace hackle
