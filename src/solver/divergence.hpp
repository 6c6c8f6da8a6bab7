// SPDX-License-Identifier: MIT
#pragma once

#include "solver/slab.hpp"
#include "solver/view.hpp"

namespace hackle {

// Throws Error (run_failed) unless every displacement and velocity is a number, and one that the
// single precision of fields can hold.
void check_finite(const View& view);

// Knows a solution that has diverged by its energy: all motion comes from work, so kinetic energy
// cannot exceed the most that was put in, apart from the error of the step.
class Divergence {
 public:
  // Another state, of this energy, in units of rho dx^4/dt^2.
  void begin(double energy) { max_energy_ = energy; }
  double max_energy() const { return max_energy_; }
  // Whether there are values as above, or a thousand times the energy that was ever put in. Looks
  // at the rows of the slab; every rank asks, and learns the same.
  bool is_seen(const View& view, const Slab& slab = undivided);
  // Throws Error (run_failed) that says where, after is_seen().
  [[noreturn]] static void tell(const View& view);

 private:
  double max_energy_ = 0.0;  // the most energy put in so far
};

}  // namespace hackle
