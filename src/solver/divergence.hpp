// SPDX-License-Identifier: MIT
#pragma once

#include "solver/view.hpp"

namespace hackle {

// Throws Error (run_failed) unless every displacement and velocity is a number, and one that the
// single precision of fields can hold. Gives back the sum of v^2, in lattice units.
double check_finite(const View& view);

// Knows a solution that has diverged by its energy: all motion comes from work, so kinetic energy
// cannot exceed the most that was put in, apart from the error of the step.
class Divergence {
 public:
  // Another state, of this energy, in units of rho dx^4/dt^2.
  void begin(double energy) { max_energy_ = energy; }
  double max_energy() const { return max_energy_; }
  // Throws Error (run_failed), as above or when there is a thousand times the energy that was ever
  // put in.
  void check(const View& view);

 private:
  double max_energy_ = 0.0;  // the most energy put in so far
};

}  // namespace hackle
