// SPDX-License-Identifier: MIT
// Rollers and platens: the law of their push, work, balance, symmetry, and what is refused.
#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// Compressed slowly between a held platen below and one that moves down by `way`.
Plate compressed(double way) {
  Plate plate = test::bare_plate(20, 40);
  plate.loads.platens.push_back({{-0.01, -0.004}, {0.02, 0.0}, Guide::displacement, {0, 0}, {}, 0});
  plate.loads.platens.push_back(
      {{-0.01, 0.02}, {0.02, 0.024}, Guide::displacement, {0.0, -way}, ramp(60e-6), 0});
  plate.loads.damping = 2e5;
  return plate;
}

// Returns the forces on the upper and the lower half, N per m of thickness.
Vec2 forces_on_halves(const Simulation& simulation) {
  Vec2 sum(0, 0);
  for (const LoadedNode& node : simulation.actions().forces)
    (node.j < 20 ? sum.x() : sum.y()) += node.acceleration.y() * 2235.0 * 0.25e-6;
  return sum;
}

// At rest both platens bear the same; the work of a spring that is loaded slowly is half the last
// force times the way, less what damping took.
TEST(GuidedBodies, CompressAPlateInBalance) {
  const double way = 4e-6;
  Simulation simulation(compressed(way), test::numerics(), {1});
  simulation.run(150e-6);
  const Vec2 force = forces_on_halves(simulation);
  EXPECT_GT(force.x(), 0.0);
  EXPECT_NEAR(force.x(), -force.y(), 1e-3 * force.x());
  // The plate between two contacts, springs of 15 c dx^2 over the horizon, in a row of nodes; nodes
  // at free edges are softer, 15 %.
  const double c = simulation.lattice().calibration.c, contact = 15.0 * c * 0.25e-6 * 0.5e-3 / 2e-3;
  const double stiff = 0.01 * way / (0.02 / 65e9 + 2.0 / contact);
  EXPECT_NEAR(force.x(), stiff, 0.15 * stiff);
  const Energy now = energy(simulation);
  EXPECT_LT(std::abs(now.residual()), 0.01 * now.external);
}

TEST(GuidedBodies, ARollerPushesByTheLawOfImpactors) {
  Plate plate = test::bare_plate(40, 20), hit = plate;
  const Vec2 from(10e-3, 14.01e-3);
  plate.loads.rollers.push_back({from, 4e-3, Guide::velocity, {0.0, -20.0}, {}, 0.2});
  hit.loads.impactors.push_back({from, 4e-3, {0.0, -20.0}, 1e9, 0.2, 1.0});  // nothing stops it
  Numerics numerics = test::numerics();
  numerics.step = 20e-9;
  Simulation led(plate, numerics, {1}), thrown(hit, numerics, {1});
  led.run(3e-6);
  thrown.run(3e-6);
  const double size = thrown.displacement(20, 19).norm();
  EXPECT_GT(size, 1e-6);
  EXPECT_LT((led.displacement(20, 19) - thrown.displacement(20, 19)).norm(), 1e-6 * size);
  EXPECT_NEAR(led.ledger().external, thrown.ledger().external, 1e-5 * thrown.ledger().external);
}

// A displacement and a velocity that say the same do the same.
TEST(GuidedBodies, FollowDisplacementsAndVelocitiesAlike) {
  Plate one = test::bare_plate(40, 20), other = one;
  const Vec2 from(10e-3, 14.01e-3);
  one.loads.rollers.push_back({from, 4e-3, Guide::velocity, {0.0, -20.0}, ramp(4e-6), 0.0});
  other.loads.rollers.push_back(
      {from,
       4e-3,
       Guide::displacement,
       {0.0, -1.0},
       Amplitude([](double t) { return t < 4e-6 ? 20.0 * t * t / 8e-6 : 20.0 * (t - 2e-6); },
                 "its integral"),
       0.0});
  Simulation a(one, test::numerics(), {1}), b(other, test::numerics(), {1});
  a.run(8e-6);
  b.run(8e-6);
  const double size = a.displacement(20, 19).norm();
  EXPECT_GT(size, 1e-6);
  EXPECT_LT((a.displacement(20, 19) - b.displacement(20, 19)).norm(), 1e-9 * size);
}

TEST(GuidedBodies, KeepSymmetryThreadsAndTheDivisionOfARun) {
  Plate plate = test::bare_plate(60, 20);
  plate.loads.rollers.push_back(
      {{15e-3, 14e-3}, 4e-3, Guide::velocity, {0.0, -10.0}, ramp(5e-6), 0.3});
  plate.loads.rollers.push_back({{15e-3, -3e-3}, 3e-3, Guide::displacement, {0.0, 0.0}, {}, 0.3});
  Simulation one(plate, test::numerics(), {1}), other(plate, test::numerics(), {3});
  one.run(30e-6);
  for (int k = 0; k < 3; ++k) other.run(10e-6);
  EXPECT_EQ(one.state().hash(), other.state().hash());
  EXPECT_EQ(test::asymmetric_nodes(one, false), 0);
  EXPECT_GT(std::abs(one.displacement(30, 19).y()), 1e-5);
}

// A platen on a free plate, pressed by a force.
Plate pressed(double force, const Amplitude& amplitude) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.platens.push_back(
      {{4e-3, 10e-3}, {16e-3, 12e-3}, {Guide::force, {0.0, -force}, amplitude}});
  return plate;
}

// Of the nodes half a step earlier, kg/s, and of the platen, whose mass is that of steel.
double momentum_of_nodes(const Simulation& simulation) {
  double sum = 0.0;
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 40; ++i) sum += simulation.state().v(i, j).y();
  return sum * 2235.0 * 0.25e-6 * 0.5e-3 / simulation.dt();
}
double momentum_of_platen(const Simulation& simulation) {
  return 7850.0 * 12e-3 * 2e-3 * simulation.state().platens.front().velocity.y() * 0.5e-3 /
         simulation.dt();
}

// What the force gives is all momentum of platen and plate together, whatever they push each other
// with, half a step before the time. Pushes are rounded to 6e-14 of a spacing per step.
TEST(GuidedBodies, AForceMovesPlatenAndPlateTogether) {
  const double force = 2e5;
  Simulation simulation(pressed(force, {}), test::numerics(), {1});
  simulation.run(20e-6);
  const double given = -force * (simulation.time() - 0.5 * simulation.dt());
  EXPECT_LT(momentum_of_nodes(simulation), 0.1 * given);
  EXPECT_NEAR(momentum_of_nodes(simulation) + momentum_of_platen(simulation), given,
              1e-9 * force * 20e-6);
  EXPECT_EQ(simulation.state().platens.front().velocity.x(), 0.0);
}

// Of the springs between a platen and cells, (15/4) c dx^3 N/m each and m of thickness.
double stored_in_contact(const Simulation& simulation) {
  const double spring = 15.0 / 4.0 * simulation.lattice().calibration.c * std::pow(0.5e-3, 3);
  double sum = 0.0;
  for (const LoadedNode& node : simulation.actions().forces)
    sum += 0.5 / spring * std::pow(node.acceleration.y() * 2235.0 * 0.25e-6, 2);
  return sum;
}

// Returns the work of a force that is switched on, less the kinetic energy of the platen, what its
// contact stores, and the work that the plate has got, over the last.
double lost_work(double dt) {
  const double force = 2e5, mass = 7850.0 * 12e-3 * 2e-3;
  Numerics numerics = test::numerics();
  numerics.step = dt;
  Simulation simulation(pressed(force, {}), numerics, {1});
  simulation.run(20e-6);
  const Disc& platen = simulation.state().platens.front();
  const double way = 11e-3 - (simulation.lattice().grid.centre.y() + 0.5e-3 * platen.centre.y());
  const double acting = -force + simulation.reactions().front().force.y();
  const double speed = platen.velocity.y() * 0.5e-3 / dt + 0.5 * dt * acting / mass;
  const double external = simulation.ledger().external;
  const double kept = 0.5 * mass * speed * speed + stored_in_contact(simulation);
  return (force * way - kept - external) / external;
}

TEST(GuidedBodies, WorkOfAForceIsThatOfPlatenAndPlateToSecondOrder) {
  const double coarse = lost_work(40e-9), fine = lost_work(20e-9);
  EXPECT_LT(std::abs(fine), 1e-2);
  EXPECT_GT(std::abs(fine), 1e-9);
  EXPECT_NEAR(coarse / fine, 4.0, 1.0);
}

// Between a held platen and one that a force presses: at rest both bear that force, and the
// platens stand apart by what bonds and both contacts give way.
TEST(GuidedBodies, BearTheForceThatIsGiven) {
  Plate plate = compressed(0.0);
  Guided& guided = plate.loads.platens[1].guided;
  guided.guide = Guide::force;
  guided.value = {0.0, -5e4};
  guided.mass = 0.1;
  plate.loads.damping = 1e5;
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(400e-6);
  const std::vector<Reaction> found = simulation.reactions();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].who, "platen");
  EXPECT_EQ(found[1].number, 2);
  EXPECT_NEAR(found[0].force.y(), -5e4, 50.0);
  EXPECT_NEAR(found[1].force.y(), 5e4, 50.0);
  EXPECT_NEAR(forces_on_halves(simulation).y(), -found[1].force.y(), 1e-6 * 5e4);
  EXPECT_LT(std::abs(found[0].force.x()), 1.0);
}

TEST(GuidedBodies, HaveTheReactionsOfImpactors) {
  Plate plate = test::bare_plate(40, 20), hit = plate;
  const Vec2 from(10e-3, 14.01e-3);
  plate.loads.rollers.push_back({from, 4e-3, {Guide::velocity, {0.0, -20.0}}});
  hit.loads.impactors.push_back({from, 4e-3, {0.0, -20.0}, 1e9});
  Simulation led(plate, test::numerics(), {1}), thrown(hit, test::numerics(), {1});
  led.run(3e-6);
  thrown.run(3e-6);
  const double force = thrown.reactions().front().force.y();
  EXPECT_GT(force, 1e3);
  EXPECT_NEAR(led.reactions().front().force.y(), force, 1e-5 * force);
  EXPECT_LT((led.reactions().front().centre - thrown.reactions().front().centre).norm(), 1e-12);
}

std::string refusal_of_body(const Plate& plate) {
  try {
    const Simulation simulation(plate, test::numerics(), {1});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(GuidedBodies, AreRefusedWhereTheyCannotBeTrue) {
  Plate inside = test::bare_plate(40, 20);
  inside.loads.rollers.push_back({{10e-3, 12e-3}, 4e-3, Guide::displacement, {0, 0}, {}, 0});
  EXPECT_THAT(refusal_of_body(inside),
              testing::HasSubstr("roller: before it moves it overlaps the plate"));
  Plate thin = test::bare_plate(40, 20);
  thin.loads.platens.push_back({{0, 10e-3}, {20e-3, 10.1e-3}, Guide::displacement, {0, 0}, {}, 0});
  EXPECT_THAT(refusal_of_body(thin), testing::HasSubstr("platen: its smaller side"));
  Plate function = test::bare_plate(40, 20);
  function.loads.rollers.push_back({{10e-3, 15e-3},
                                    4e-3,
                                    Guide::velocity,
                                    {0, -1},
                                    Amplitude([](double t) { return t; }, "t"),
                                    0});
  EXPECT_THAT(refusal_of_body(function),
              testing::HasSubstr("roller: a velocity goes with a table"));
  Plate light = pressed(1e5, {});
  light.loads.platens.front().guided.mass = 0.01;  // nodes: 12 mm times 0.5 mm of glass
  EXPECT_THAT(refusal_of_body(light), testing::HasSubstr("its mass of 0.01 kg/m is less"));
  Plate nowhere = pressed(0.0, {});
  EXPECT_THAT(refusal_of_body(nowhere), testing::HasSubstr("platen: its force is 0"));
}

// Before the first step of the run in which it would happen.
TEST(GuidedBodies, DoNotJump) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.rollers.push_back(
      {{10e-3, 15e-3}, 4e-3, {Guide::displacement, {0, -1e-3}, step_at(5e-6)}});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(4e-6);
  try {
    simulation.run(4e-6);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("roller: in the step at 4."));
  }
  EXPECT_LT(simulation.time(), 5e-6);
}

}  // namespace
}  // namespace hackle
