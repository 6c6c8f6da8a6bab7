// SPDX-License-Identifier: MIT
// What takes the nodes and bonds of a plate through a step, wherever it does so: on the threads of
// this machine (cpu/engine.hpp), alone or as one of several ranks, and in times to come on a
// device. It is made for one lattice and one precision, which it is given again with every call.
#pragma once

#include <memory>
#include <vector>

#include "solver/actions.hpp"
#include "solver/broken_bond.hpp"
#include "solver/path_counts.hpp"
#include "solver/slab.hpp"
#include "solver/state.hpp"

namespace hackle {

class Stepper {
 public:
  virtual ~Stepper() = default;
  virtual std::unique_ptr<Stepper> clone() const = 0;

  // Must be called before the first step, and whenever a state is not the one that step() left. A
  // state at its start gets the thresholds that follow from its displacements, as if it had been
  // there a step earlier.
  virtual void prepare(const Lattice& lattice, State& state) = 0;

  // Sets the loads from now on.
  virtual void set_actions(const Actions& actions) = 0;
  // Sets the thermal strain of every node from now on, by Grid::index; only where the stepper was
  // made for a plate that is heated.
  virtual void set_heat(const Lattice& lattice, const std::vector<double>& strain) = 0;

  // Advances u, v, bonds and thresholds by one step; the caller updates the rest of the state. v
  // changes by `kick` times the acceleration.
  virtual void step(const Lattice& lattice, State& state, double kick) = 0;

  // Where a rank moves its own rows only: which those are, from now on to the next step, and what
  // gives every rank all of the state.
  virtual const Slab& slab() const { return undivided; }
  virtual void complete(State&) {}

  // Of every node at the time of u, by Grid::index, in lattice units, as if none were prescribed.
  virtual std::vector<Vec2> accelerations(const Lattice& lattice, const State& state) = 0;

  // Returns the work of supports up to the beginning of the last step, in units of rho dx^4/dt^2
  // (src/solver/README.md 3.5).
  virtual double prescribed_work() const = 0;

  // Returns the bonds that broke in the last step, or those given to note_broken_bonds().
  virtual const std::vector<BrokenBond>& broken_bonds() const = 0;
  virtual void note_broken_bonds(std::vector<BrokenBond> broken_bonds) = 0;

  virtual const PathCounts& path_counts() const = 0;  // so far
  virtual std::size_t bytes() const = 0;              // of everything that grows with the plate
};

}  // namespace hackle
