// SPDX-License-Identifier: MIT
#include "solver/view.hpp"

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "measure/field.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

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

}  // namespace
}  // namespace hackle
