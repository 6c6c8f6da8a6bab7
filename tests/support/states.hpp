// SPDX-License-Identifier: MIT
// States prepared by hand.
#pragma once

#include <random>

#include "solver/simulation.hpp"

namespace hackle::test {

// The state of `simulation` with u set to displacement(i, j), in units of dx. `displacement` takes
// the place from the centre of the lattice in units of dx and returns a Vec2.
template <class Displacement>
State displaced(const Simulation& simulation, Displacement displacement) {
  State state = simulation.state();
  const Grid& grid = simulation.lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) state.set_u(i, j, displacement(grid.from_centre(i, j)));
  return state;
}

// Adds random velocities, uniform in +-most (in units of dx a step).
inline State shaken(State state, double most, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-most, most);
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i)
      state.set_v(i, j, state.v(i, j) + Vec2(uniform(random), uniform(random)));
  return state;
}

}  // namespace hackle::test
