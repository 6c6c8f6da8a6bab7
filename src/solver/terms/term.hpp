// SPDX-License-Identifier: MIT
// A phenomenon that takes part in the steps of a plate: what it needs to know, what it does to a
// step, its work, its memory. A plate has the terms that its scene uses, and no other.
//
// All functions but clone() and name() have a default that does nothing; a term answers those that
// concern it. They are called a few times a step, never once per node.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/actions.hpp"
#include "solver/cloned.hpp"
#include "solver/ledger.hpp"
#include "solver/reaction.hpp"
#include "solver/slab.hpp"
#include "solver/state.hpp"
#include "solver/stepper.hpp"
#include "solver/threads.hpp"

namespace hackle {

class Term;

// What a term works with, besides the state.
struct Surroundings {
  const Lattice& lattice;
  double dt;  // s
  const Threads& threads;
  Stepper& stepper;
  std::span<const Cloned<Term>> terms;  // all of the plate, in their order
  const std::vector<double>& heat;      // thermal strain by Grid::index; empty where it is 0
  const Slab& slab;                     // the rows whose nodes it concerns

  // J/m: rho dx^4/dt^2, the mass of a node times (dx/dt)^2.
  double energy_unit() const {
    const double dx = lattice.grid.dx;
    return lattice.rho * dx * dx * (dx / dt) * (dx / dt);
  }
};

// Loads that vary do half the work of a step with what acts at its beginning, and half with what
// acts at its end (src/solver/README.md 3.4).
enum class WorkOf { whole_step, first_half, second_half };

class Term {
 public:
  virtual ~Term() = default;
  virtual std::unique_ptr<Term> clone() const = 0;
  // Its line in the report; terms of one name share it. "" for what takes no time in a step.
  virtual std::string_view name() const = 0;

  // Asks functions of time now for all steps begin <= n < end. Throws what they throw.
  virtual void tabulate(const Clock&, std::int64_t, std::int64_t, double) {}

  // Takes up a state that is not the one of the last step, before anything else is asked.
  virtual void begin(const Surroundings&, State&) {}
  // Whether in steps it looks only at nodes of the slab and of the rows within reach of it, and
  // sums by RowSum. Where a term does not, every rank of a plate gets all nodes after every step.
  virtual bool keeps_to_rows() const { return false; }
  // Before a step: what acts on the velocities. Gives back the kick of the step: what an
  // acceleration does to v, in steps.
  virtual double before_step(const Surroundings&, State&, double kick) { return kick; }
  // After a step: what moves or breaks with the plate.
  virtual void follow(const Surroundings&, State&) {}
  // Computes the loads of the step that begins with this state. Returns whether they have changed.
  virtual bool update(const Surroundings&, State&) { return false; }

  // What update() or halt() found: each node once, ordered by index.
  virtual std::span<const LoadedNode> forces() const { return {}; }
  virtual std::span<const PrescribedNode> prescribed() const { return {}; }
  // Thermal strain by Grid::index; nullptr for a term that heats nothing.
  virtual const std::vector<double>* thermal_strain() const { return nullptr; }

  // Whether its forces differ from step to step, or it leads nodes.
  virtual bool varies() const { return false; }
  // The part of its forces that resists motion and only takes energy, likewise: Terms books its
  // work as damped. A term that has one varies().
  virtual std::span<const LoadedNode> drag() const { return {}; }
  // Whether it has some on any rank.
  virtual bool resists() const { return !drag().empty(); }
  // Adds the work that its other forces do in a step, of which `state` is the end, in units of rho
  // dx^4/dt^2, here as below.
  virtual void add_work(const Surroundings&, const State&, WorkOf, double&) const {}
  // Adds what the state's ledger does not know yet: the half step that is open, what is stored now.
  virtual void add_open(const Surroundings&, const State&, Ledger&) const {}
  // What it stores now, by which the plate can be set in motion.
  virtual double stored() const { return 0.0; }
  // What it stores more when the thermal strain changes while nodes stay where they are.
  virtual double heat_work(const std::vector<double>&, const std::vector<double>&) const {
    return 0.0;
  }

  // Throws Error (refused), in the name of `who`, where it has no part in a plate at rest.
  virtual void check_rest(const std::string&) const {}
  // Finds what acts on a plate that stands still at the time of u: loads and displacements of this
  // very moment, whatever the step. Nodes that are led at a velocity go as far as that makes in the
  // time that has `passed` since they were where they are, s. update() must follow before the next
  // step, and says true then.
  virtual void halt(const Surroundings&, const State&, double) {}
  // Whether its forces act on a plate at rest.
  virtual bool acts_at_rest() const { return false; }

  // Adds the forces of the plate on the rigid bodies of the term, now.
  virtual void add_reactions(const Surroundings&, const State&, std::vector<Reaction>&) const {}

  virtual std::size_t bytes() const { return 0; }  // of what grows with the plate
};

}  // namespace hackle
