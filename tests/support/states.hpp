// SPDX-License-Identifier: MIT
// Prepares states, and evaluates them.
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle::test {

// Returns the state of `simulation` with u set to displacement(i, j), in units of dx.
// `displacement` takes the position relative to the centre of the lattice in units of dx and
// returns a Vec2.
template <class Displacement>
State displaced(const Simulation& simulation, Displacement displacement) {
  State state = simulation.state();
  const Grid& grid = simulation.lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) state.set_u(i, j, displacement(grid.from_centre(i, j)));
  return state;
}

// Does the same for v, in units of dx per step.
template <class Velocity>
State thrown(const Simulation& simulation, Velocity velocity) {
  State state = simulation.state();
  const Grid& grid = simulation.lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) state.set_v(i, j, velocity(grid.from_centre(i, j)));
  return state;
}

// Adds random velocities, uniform in +-most (in units of dx per step).
inline State shaken(State state, double max, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-max, max);
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i)
      state.set_v(i, j, state.v(i, j) + Vec2(uniform(random), uniform(random)));
  return state;
}

// Adds random displacements, uniform in +-most (in units of dx) and exact in single precision.
inline State jolted(State state, double max, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-static_cast<float>(max), static_cast<float>(max));
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i)
      state.set_u(i, j, state.u(i, j) + Vec2(uniform(random), uniform(random)));
  return state;
}

// Returns the accelerations due to the displacements of `simulation`, in units of dx per step
// squared, by Grid::index: twice the velocities after a first step from rest.
inline std::vector<Vec2> accelerations(const Simulation& simulation) {
  Simulation probe = simulation;
  State state = thrown(simulation, [](const Vec2&) { return Vec2(0, 0); });
  state.step = 0;
  probe.restore(std::move(state));
  probe.step();
  const Grid& grid = probe.lattice().grid;
  std::vector<Vec2> result;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) result.emplace_back(2.0 * probe.state().v(i, j));
  return result;
}

// Returns the largest component.
inline double largest(const std::vector<Vec2>& values) {
  double max = 0.0;
  for (const Vec2& value : values) max = std::max(max, value.cwiseAbs().maxCoeff());
  return max;
}

// Returns the state from which time runs backwards: the same u, opposite velocities.
inline State reversed(const Simulation& simulation) {
  State state = simulation.state();
  const Grid& grid = simulation.lattice().grid;
  const std::vector<Vec2> velocities = simulation.velocities();
  const double unit = simulation.dt() / grid.dx;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) state.set_v(i, j, -unit * velocities[grid.index(i, j)]);
  state.step = 0;
  return state;
}

}  // namespace hackle::test
