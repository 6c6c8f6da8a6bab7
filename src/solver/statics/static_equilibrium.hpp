// SPDX-License-Identifier: MIT
// Static equilibrium: where a plate comes to rest under what acts on it, without breaking.
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
#include "solver/statics/static_work.hpp"

namespace hackle {

class CoarseSpace;

struct Equilibrium {
  NodeVectors u;    // dx, without the state's origin
  StaticWork work;  // on the way there, besides heat and motion
  std::vector<Overstretched> beyond;
  RelaxResult result;
};

// Newton's method on the exact forces of the bonds (LinearisedBonds), which pull however far they
// are stretched; each step solved by conjugate gradients (ConjugateGradient), and halved while it
// would leave more force than there was. The tangent is taken anew when a step has left more than a
// tenth of the force, the coarse space when the iterations have doubled. Prescribed displacements
// enter with the first step. Nodes without bonds stay. Fragments that nothing holds keep their
// place, and turn only as far as the loads on the deformed fragment demand. Neither damping nor
// contact nor impactors take part.
class StaticEquilibrium {
 public:
  // `actions` is what acts at rest (Terms::halt), `heat` how nodes are strained
  // (LinearisedBonds). Lattice, state and heat must outlive it.
  StaticEquilibrium(const Lattice& lattice, const State& state, const Actions& actions,
                    std::span<const double> heat, const Threads& threads);

  ~StaticEquilibrium();

  // Says under which loads and heat the plate stood before, if others than act now.
  void comes_from(const std::vector<LoadedNode>& loads, std::span<const double> heat);

  // Throws Error (refused) when loads push or turn a fragment that nothing holds, Error
  // (run_failed) when there is no equilibrium to be found, and Error (interrupted).
  Equilibrium solve(const RelaxOptions& options);

  // Takes note that these bonds of the state have broken since solve(), which must then be called
  // again: it goes on from where the plate came to rest, under the same loads, with nothing
  // prescribed. What is known of the tangent is kept.
  void lose(const std::vector<BrokenBond>& broken_bonds);

 private:
  // What is left of the forces on mobile nodes, and what to compare it with.
  struct Balance {
    double largest = 0.0;    // at a node
    double total = 0.0;      // root of the sum of squares
    double reference = 0.0;  // largest load or reaction
    double rounding = 0.0;
  };

  void take_loads(const std::vector<LoadedNode>& forces, NodeVectors& load) const;
  void take_prescribed(const std::vector<PrescribedNode>& prescribed);
  void check_held(const RelaxOptions& options) const;
  void refuse(const Fragment& fragment, const Resultant& resultant, const std::string& who) const;
  bool turn_free_fragments(const RelaxOptions& options);  // true when one has turned
  void hold_lonely_nodes();
  void set_out();
  Balance find_left();  // residual_
  double stiffest() const;
  NodeVectors newton_step(double goal, const RelaxOptions& options, RelaxResult& result);
  bool improve(const NodeVectors& step, Balance& balance);
  bool take_tangent();  // false when the tangent has to be the positive one
  StaticWork work_done() const;

  const Lattice* lattice_;
  const State* state_;
  LinearisedBonds net_;
  NodeVectors u_, load_, mobile_, move_, residual_, pull_;
  Posture before_;
  Fragments fragments_;
  Tangent tangent_ = Tangent::exact;
  bool is_prescribed_ = false;  // move_ is not 0
  double largest_load_ = 0.0;
  double max_left_ = 0.0;  // that conjugate gradients have seen
  bool stale_ = true;      // the tangent is to be taken anew
  std::unique_ptr<CoarseSpace> coarse_;
  int iterations_then_ = 0;  // of the first step with this coarse space; 0 before it
};

}  // namespace hackle
