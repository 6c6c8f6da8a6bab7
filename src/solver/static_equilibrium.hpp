// SPDX-License-Identifier: MIT
// Static equilibrium: where a plate comes to rest under what acts on it, without breaking.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/fragments.hpp"
#include "solver/linearised_bonds.hpp"
#include "solver/loading.hpp"
#include "solver/static_work.hpp"

namespace hackle {

class CoarseSpace;

struct RelaxOptions {
  // The largest force left on a node over the largest load or reaction on a node, in (0, 1). Where
  // there is neither: over the largest force at the beginning.
  double tolerance = 1e-8;
  // Called from time to time with the progress, 0..1; may throw, which leaves all as it was.
  std::function<void(double fraction, int iterations)> progress;
  // For messages: the user's call, and how an interrupt leaves the plate.
  std::string who = "relax";
  std::string left = "as it was";
};

struct RelaxResult {
  int iterations = 0;  // of conjugate gradients, in all Newton steps
  int newton_steps = 0;
  double residual = 0.0;    // what is left, in the units of the tolerance
  double most = 0.0;        // the largest stretch of a bond over its critical stretch
  std::int64_t beyond = 0;  // bonds above 1, which the next step will break
};

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
  // `loading` says what acts at rest (Loading::halt), `heat` how nodes are strained
  // (LinearisedBonds). All must outlive it.
  StaticEquilibrium(const Lattice& lattice, const State& state, const Loading& loading,
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
  void take_prescribed(const Loading& loading);
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
