// SPDX-License-Identifier: MIT
// Plates at rest between rollers and platens, against slow runs, closed forms and balance.
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// 10 by 20 mm between a held platen below and one above, which `guided` leads.
Plate between_platens(const Guided& guided) {
  Plate plate = test::bare_plate(20, 40);
  plate.loads.platens.push_back({{-0.01, -0.004}, {0.02, 0.0}, {}});
  plate.loads.platens.push_back({{-0.01, 0.02}, {0.02, 0.024}, guided});
  return plate;
}

Guided by_way(double way, const Amplitude& amplitude = {}) {
  return {Guide::displacement, {0.0, -way}, amplitude};
}

Vec2 reaction(const Simulation& simulation, std::size_t body) {
  return simulation.reactions().at(body).force;
}

// The run is damped until it stands: to 1e-4 of its force.
TEST(RigidContacts, AtRestAPlateBearsWhatItBearsAfterASlowRun) {
  Plate slow = between_platens(by_way(4e-6, ramp(60e-6)));
  slow.loads.damping = 2e5;
  Simulation run(slow, test::numerics(), {1}),
      rest(between_platens(by_way(4e-6)), test::numerics(), {1});
  run.run(300e-6);
  rest.relax({1e-10, {}});
  const double force = reaction(run, 1).y();
  EXPECT_GT(force, 1e4);
  EXPECT_NEAR(reaction(rest, 1).y(), force, 2e-4 * force);
  EXPECT_NEAR(reaction(rest, 0).y(), -reaction(rest, 1).y(), 1e-6 * force);
  for (const int j : {0, 20, 39})
    EXPECT_LT((rest.displacement(10, j) - run.displacement(10, j)).norm(), 1e-3 * 4e-6) << j;
}

// What stands goes on standing: pushes in motion are those at rest.
TEST(RigidContacts, APlateGoesOnStanding) {
  Simulation rest(between_platens(by_way(4e-6)), test::numerics(), {1});
  rest.relax({1e-10, {}});
  const Vec2 before = rest.displacement(3, 30);
  const double strain = energy(rest).strain;
  rest.run(10e-6);
  EXPECT_LT((rest.displacement(3, 30) - before).norm(), 1e-6 * 4e-6);
  EXPECT_LT(energy(rest).kinetic, 1e-10 * strain);
}

// A platen that is pressed by the force that another one bears stands where that one was led.
TEST(RigidContacts, AForceLeadsToWhereItIsBorne) {
  Simulation led(between_platens(by_way(4e-6)), test::numerics(), {1});
  led.relax({1e-10, {}});
  const double force = reaction(led, 1).y();
  Simulation pressed(between_platens({Guide::force, {0.0, -force}}), test::numerics(), {1});
  pressed.relax({1e-10, {}});
  EXPECT_NEAR(reaction(pressed, 1).y(), force, 1e-8 * force);
  EXPECT_NEAR(reaction(pressed, 0).y(), -force, 1e-6 * force);
  EXPECT_NEAR(pressed.reactions()[1].centre.y(), 0.022 - 4e-6, 1e-6 * 4e-6);
  pressed.run(5e-6);
  EXPECT_NEAR(pressed.reactions()[1].centre.y(), 0.022 - 4e-6, 1e-5 * 4e-6);
}

// External work is that of the pushes; all of it is strain. Forces grow with the way, more so as
// more cells touch: trapezoids are right to second order in the increment.
TEST(RigidContacts, SlowLoadingBalancesItsLedger) {
  for (const bool by_force : {false, true}) {
    Guided guided =
        by_force ? Guided{Guide::force, {0.0, -1e4}, ramp(1e-3)} : by_way(4e-6, ramp(1e-3));
    Simulation simulation(between_platens(guided), test::numerics(), {1});
    simulation.load_slowly({1e-3, 5, 1e-9, {}});
    const Energy now = energy(simulation);
    EXPECT_GT(now.strain, 0.0);
    EXPECT_NEAR(now.external, now.strain, 1e-3 * now.strain);
    EXPECT_LT(std::abs(now.released), 1e-3 * now.strain);
  }
}

// A bar of 60 by 6 mm on two rollers 50 mm apart, pressed in the middle by a third: each support
// bears half, and the deflection is that of a beam with the shear of its middle third (Timoshenko),
// which the soft rims of a plate of 12 rows, 3 horizons, exceed by a third at most.
TEST(RigidContacts, ABarBendsBetweenThreeRollers) {
  Plate plate = test::bare_plate(120, 12);
  const double force = 1e3, span = 50e-3, h = 6e-3, radius = 3e-3;
  for (const double x : {5e-3, 55e-3}) plate.loads.rollers.push_back({{x, -radius}, radius, {}});
  plate.loads.rollers.push_back({{30e-3, h + radius}, radius, {Guide::force, {0.0, -force}}});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.relax({1e-9, {}});
  EXPECT_NEAR(reaction(simulation, 0).y(), -0.5 * force, 1e-4 * force);
  EXPECT_NEAR(reaction(simulation, 1).y(), -0.5 * force, 1e-4 * force);
  EXPECT_NEAR(reaction(simulation, 0).x(), -reaction(simulation, 1).x(), 1e-4 * force);
  const double sagging =
      0.5 * (simulation.displacement(10, 6).y() + simulation.displacement(109, 6).y()) -
      simulation.displacement(60, 6).y();
  const double slender = h / span;
  const double beam = force * std::pow(span / h, 3) / (4.0 * 65e9) *
                      (1.0 + 2.85 * slender * slender - 0.84 * slender * slender * slender);
  EXPECT_GT(sagging, beam);
  EXPECT_LT(sagging, 1.33 * beam);
}

// A disc between two platens that are led towards each other grows across by (nu + 4/pi - 1) F/E
// (Hondros), whatever the contact; 25 cells in its radius are 3 % off.
TEST(RigidContacts, ADiscBetweenPlatensGrowsAcross) {
  Plate plate = test::bare_plate(100, 100);
  const double R = 25e-3;
  plate.outlines.push_back({{Ellipse{{R, R}, {R, R}, 0.0}}, ""});
  plate.loads.platens.push_back({{0.0, -5e-3}, {2 * R, 0.0}, {Guide::displacement, {0, 2e-6}}});
  plate.loads.platens.push_back(
      {{0.0, 2 * R}, {2 * R, 2 * R + 5e-3}, {Guide::displacement, {0, -2e-6}}});
  Numerics numerics = test::numerics();
  numerics.quadrature = Quadrature::area;
  Simulation simulation(plate, numerics, {1});
  simulation.relax({1e-9, {}});
  EXPECT_EQ(test::asymmetric_nodes(simulation, false), 0);
  const double force = reaction(simulation, 1).y();
  const double growth = simulation.displacement(99, 50).x() - simulation.displacement(0, 50).x();
  const double hondros = force / 65e9 * (1.0 / 3.0 + 4.0 / std::numbers::pi - 1.0);
  EXPECT_NEAR(growth, hondros, 0.03 * hondros);
}

std::string refusal_of_rest(const Plate& plate) {
  Simulation simulation(plate, test::numerics(), {1});
  const std::string before = simulation.state().hash();
  try {
    simulation.relax();
  } catch (const Error& error) {
    EXPECT_EQ(simulation.state().hash(), before);
    return error.what();
  }
  return "";
}

TEST(RigidContacts, RefuseWhatNothingBears) {
  Plate away = between_platens({Guide::force, {0.0, 1e4}});
  EXPECT_THAT(refusal_of_rest(away), testing::HasSubstr("relax: nothing bears the force"));
  Plate alone = between_platens({Guide::force, {0.0, -1e4}});
  alone.loads.platens.erase(alone.loads.platens.begin());
  EXPECT_THAT(refusal_of_rest(alone), testing::HasSubstr("nothing holds it"));
}

}  // namespace
}  // namespace hackle
