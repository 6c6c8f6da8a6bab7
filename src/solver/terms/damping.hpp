// SPDX-License-Identifier: MIT
// Viscous damping: velocities decay as exp(-rate t).
//
// A step sets v to keep v + yield a, which is the exact motion under a constant force: keep =
// exp(-x), yield = (1 - keep)/x, x = rate dt. It is of second order in the step, a plate creeps
// under a load at the right velocity for any x, and the step limit does not change: a mode of Omega
// = omega dt obeys z^2 - (1 + keep - yield Omega^2) z + keep = 0, whose roots lie in the unit
// circle for yield Omega^2 < 2 (1 + keep), that is Omega^2 < 2 x coth(x/2), which is never below 4.
#pragma once

#include <span>

#include "solver/terms/term.hpp"

namespace hackle {

// The effect of damping over a time `x`, in units of 1/rate; none if that is 0.
struct Damping {
  explicit Damping(double x);

  double keep = 1.0;
  double yield = 1.0;
  // The energy dissipated in a step, as a share of free_motion(): x, because the power is rate v^2.
  // Smaller values at both ends make the ledger exact for a plate without forces: `first` for the
  // motion at the start, and `last` for the most recent step.
  double loss = 0.0;
  double first = 0.0;
  double last = 0.0;
};

// Computes the sum of v^2 over all free components, weighted by the density relative to that of the
// plate's own material. The bits are the same for any number of threads.
double free_motion(const Surroundings& around, std::span<const PrescribedNode> prescribed,
                   const State& state);

// Multiplies every free velocity component by `keep`.
void damp(const Surroundings& around, std::span<const PrescribedNode> prescribed, double keep,
          State& state);

class ViscousDamping final : public Term {
 public:
  explicit ViscousDamping(double rate) : rate_(rate) {}  // 1/s, above 0

  std::unique_ptr<Term> clone() const override { return std::make_unique<ViscousDamping>(*this); }
  std::string_view name() const override { return "damping"; }
  bool keeps_to_rows() const override { return true; }
  // Damps v from its own time to the middle of the next step (src/solver/README.md 3.7).
  double before_step(const Surroundings& around, State& state, double kick) override;
  void add_open(const Surroundings& around, const State& state, Ledger& ledger) const override;
  // What it takes in the second half of the last step from nodes that are not prescribed, which is
  // no longer so when others are.
  double lost_in_half_step(const Surroundings& around, const State& state) const;

 private:
  double rate_;
};

// The nodes that are prescribed by one of the terms.
std::span<const PrescribedNode> prescribed_in(const Surroundings& around);

}  // namespace hackle
