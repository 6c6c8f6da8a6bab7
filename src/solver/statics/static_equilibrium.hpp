// SPDX-License-Identifier: MIT
// The static equilibrium of a plate under its loads, without breaking.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/actions.hpp"
#include "solver/statics/fragments.hpp"
#include "solver/statics/linearised_bonds.hpp"
#include "solver/statics/rest.hpp"
#include "solver/statics/rigid_contacts.hpp"
#include "solver/statics/static_work.hpp"

namespace hackle {

class CoarseSpace;

struct Equilibrium {
  NodeVectors u;    // dx, without the state's origin
  StaticWork work;  // on the way there, besides heat and motion
  std::vector<Overstretched> beyond;
  RelaxResult result;
};

// Solves by Newton's method on the exact forces of the bonds (LinearisedBonds), which pull however
// far they are stretched; each step uses conjugate gradients (ConjugateGradient), and is halved
// while it would increase the residual. The tangent is renewed if a step has left more than a tenth
// of the force, the coarse space if the iterations have doubled. Prescribed displacements are
// applied in the first step. Nodes without bonds stay. Free fragments keep their place, and rotate
// only as far as the loads on the deformed fragment demand. Rollers and platens push as they do in
// motion, without friction; damping, contact and impactors are ignored.
class StaticEquilibrium {
 public:
  // `actions` is what acts at rest (Terms::halt), `heat` how nodes are strained
  // (LinearisedBonds). Lattice, state and heat must outlive it.
  StaticEquilibrium(const Lattice& lattice, const State& state, const Actions& actions,
                    std::span<const double> heat, const Threads& threads,
                    RigidContacts contacts = {});

  ~StaticEquilibrium();

  // Sets the loads, contacts and heat under which the plate stood before, if they differ from the
  // present ones.
  void comes_from(const std::vector<LoadedNode>& loads, const RigidContacts& contacts,
                  std::span<const double> heat);
  // Where bodies stand, after solve().
  const RigidContacts& contacts() const { return contacts_; }

  // Throws Error (refused) if loads push or rotate a free fragment, Error (run_failed) if no
  // equilibrium is found, and Error (interrupted).
  Equilibrium solve(const RelaxOptions& options);

  // Removes these bonds, which have broken since solve(). solve() must then be called again: it
  // continues from the last equilibrium, under the same loads, without prescribed motion, and keeps
  // the tangent.
  void lose(const std::vector<BrokenBond>& broken_bonds);

 private:
  // The residual forces on mobile nodes, and their reference.
  struct Balance {
    double largest = 0.0;    // at a node
    double total = 0.0;      // root of the sum of squares
    double reference = 0.0;  // largest load or reaction
    double rounding = 0.0;
  };

  void take_loads(const std::vector<LoadedNode>& forces, NodeVectors& load) const;
  void take_prescribed(const std::vector<PrescribedNode>& prescribed);
  void check_held(const NodeVectors& load, double largest, const RelaxOptions& options) const;
  void refuse(const Fragment& fragment, const Resultant& resultant, const std::string& who) const;
  bool turn_free_fragments(const RelaxOptions& options);  // returns whether one has rotated
  void hold_lonely_nodes();
  void set_out();
  Balance find_left();  // residual_
  double stiffest() const;
  void touch();  // finds contacts at u_
  NodeVectors all_loads() const;
  Fragments fragments() const;
  NodeVectors newton_step(double goal, const RelaxOptions& options, RelaxResult& result);
  bool improve(const NodeVectors& step, Balance& balance);
  bool take_tangent();  // returns false if the tangent must be the positive one
  StaticWork work_done() const;

  const Lattice* lattice_;
  const State* state_;
  LinearisedBonds net_;
  RigidContacts contacts_;
  NodeVectors u_, load_, mobile_, move_, residual_, pull_, push_;
  Posture before_;
  Fragments fragments_;
  Tangent tangent_ = Tangent::exact;
  bool is_prescribed_ = false;  // move_ is not 0
  double largest_load_ = 0.0;
  double max_left_ = 0.0;        // largest residual seen by conjugate gradients
  bool stale_ = true;            // the tangent must be renewed
  bool touches_others_ = false;  // the springs of contacts are not those of the coarse space
  std::unique_ptr<CoarseSpace> coarse_;
  int iterations_then_ = 0;  // in the first step with this coarse space; 0 before it
};

}  // namespace hackle
