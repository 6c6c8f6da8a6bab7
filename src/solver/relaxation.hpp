// SPDX-License-Identifier: MIT
// Static equilibrium: where a plate comes to rest under what acts on it, without breaking.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solver/bond_net.hpp"
#include "solver/loading.hpp"
#include "solver/pieces.hpp"

namespace hackle {

struct RelaxOptions {
  // Of what is left of the force on a node to the largest load or reaction of one, in (0, 1).
  // Without any, to what the force was before.
  double tolerance = 1e-8;
  // Told from time to time how far it has come, 0..1; may throw, which leaves all as it was.
  std::function<void(double fraction, int iterations)> progress;
};

struct RelaxResult {
  int iterations = 0;  // of conjugate gradients, in all Newton steps
  int newton_steps = 0;
  double residual = 0.0;    // what is left, in the units of the tolerance
  double most = 0.0;        // the largest stretch of a bond over its critical stretch
  std::int64_t beyond = 0;  // bonds above 1, which the next step will break
};

struct Equilibrium {
  NodeVectors u;  // dx, without the state's origin
  std::vector<Overstretched> beyond;
  RelaxResult result;
};

// Newton's method on the exact forces of the bonds (BondNet), which pull however far they are
// stretched; each step solved by conjugate gradients (StaticSolve), and halved while it would
// leave more force than there was. Prescribed displacements enter with the first step. Nodes
// without bonds stay. Pieces that nothing holds keep their place, and turn only as far as the loads
// on the deformed piece demand. Neither damping nor contact nor impactors take part.
class Relaxation {
 public:
  // `loading` says what acts at rest (Loading::halt). All must outlive it.
  Relaxation(const Lattice& lattice, const State& state, const Loading& loading,
             const Threads& threads);

  // Throws Error (refused) when loads push or turn a piece that nothing holds, Error (run_failed)
  // when there is no equilibrium to be found, and Error (interrupted).
  Equilibrium solve(const RelaxOptions& options);

 private:
  // What is left of the forces on mobile nodes, and what to compare it with.
  struct Balance {
    double largest = 0.0;    // at a node
    double total = 0.0;      // root of the sum of squares
    double reference = 0.0;  // largest load or reaction
    double rounding = 0.0;
  };

  void take_loads(const Loading& loading);
  void check_held(double tolerance) const;
  void refuse(const Piece& piece, const Resultant& resultant) const;
  void turn_free_pieces(double tolerance);
  Balance find_left();  // residual_
  double stiffest() const;
  NodeVectors newton_step(double goal, const RelaxOptions& options, RelaxResult& result);
  bool improve(const NodeVectors& step, const Balance& before);

  const Lattice* lattice_;
  BondNet net_;
  NodeVectors u_, load_, mobile_, move_, residual_;
  Pieces pieces_;
  Tangent tangent_ = Tangent::exact;
  bool is_led_ = false;  // move_ is not 0
  double largest_load_ = 0.0;
  double most_left_ = 0.0;  // that conjugate gradients have seen
};

}  // namespace hackle
