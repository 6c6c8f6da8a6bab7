// SPDX-License-Identifier: MIT
#include "solver/view.hpp"

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "measure/field.hpp"
#include "solver/simulation.hpp"
#include "support/composite.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// A state whose u and v belong to the same time needs nothing but itself.
TEST(View, OfAStateAtItsStartIsThatOfASimulation) {
  Plate plate = test::edge_crack(12e6);
  plate.initial_conditions.push_back({{}, {}, {1.0, 2.0}});
  const Simulation simulation(plate, test::numerics(), {1});
  const State state = simulation.state();
  const std::vector<double> cold;
  const View view(simulation.plate(), simulation.numerics(), simulation.lattice(), simulation.dt(),
                  state, cold);
  EXPECT_EQ(view.velocities(), simulation.velocities());
  EXPECT_EQ(damage(view).values, damage(simulation).values);
  EXPECT_EQ(energy(view).kinetic, energy(simulation).kinetic);
  EXPECT_EQ(view.ledger().external, simulation.ledger().external);
  EXPECT_EQ(view.displacement(3, 4), simulation.displacement(3, 4));
  EXPECT_EQ(view.time(), simulation.time());
}

// In the middle of a run v is half a step old: a view of the simulation knows that.
TEST(View, OfASimulationFollowsIt) {
  Simulation simulation(test::edge_crack(12e6), test::numerics(), {1});
  const View view = simulation;
  simulation.run(1e-6);
  EXPECT_EQ(view.time(), simulation.time());
  EXPECT_EQ(view.velocities(), simulation.velocities());
  EXPECT_NE(view.velocities()[5].y(),
            simulation.lattice().grid.dx / simulation.dt() * simulation.state().v(5, 0).y());
}

// Materials, heat, damping, loads, supports, contact and a disc: what acts on one node is what the
// stepper makes of it.
TEST(View, TheVelocityOfANodeIsThatOfTheWholePlate) {
  Plate plate = test::composite(34, 20, {true, true, 0.25});
  plate.cracks.push_back({{0.0, 0.35 * plate.height}, {0.3 * plate.width, 0.35 * plate.height}});
  plate.loads.tractions.push_back({Edge::top, {5e6, 40e6}});
  plate.loads.damping = 2e5;
  Support support;
  support.region = strip(plate, Edge::bottom, 1e-3);
  support.kind = Support::Kind::velocity;
  support.value = Vec2(0.0, -3.0);
  support.along_x = false;
  plate.loads.supports.push_back(support);
  plate.contact = Contact{};
  // A bond that breaks in the next step pulls in one of them only.
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {plate.width, plate.height}));
  Simulation simulation(plate, test::numerics(0.5e-3, 1.6e-3), {1});
  for (const int steps : {0, 1, 40}) {
    for (int k = 0; k < steps; ++k) simulation.step();
    const std::vector<Vec2> all = simulation.velocities();
    const double largest = test::largest(all);
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 34; ++i)
        EXPECT_LE(
            (simulation.view().velocity(i, j) - all[simulation.lattice().grid.index(i, j)]).norm(),
            1e-12 * largest)
            << i << " " << j << " after " << steps;
  }
}

}  // namespace
}  // namespace hackle
