// SPDX-License-Identifier: MIT
// The time at which a plate is seen, which may lie between two steps.
#pragma once

#include <algorithm>
#include <memory>

#include "solver/state.hpp"

namespace hackle {

// Between the steps n - 1 and n, at t = t_n - behind dt, displacements and discs are taken on the
// straight line between the two: u(t) = u_n - behind dt v_(n-1/2). Velocities, which View knows,
// are v(t) = v_(n-1/2) + (1/2 - behind) dt a_n. All else, such as bonds, energies and temperatures,
// is that of step n. The state itself never moves: a run has the same bits whatever is seen of it
// (src/solver/README.md 3.9).
class Instant {
 public:
  // At `time`, s; `behind` is in steps, 0 to 1. The share of a step that rounding makes is none.
  Instant(double time, double behind)
      : time_(time), behind_(behind < rounding ? 0.0 : std::min(behind, 1.0)) {}

  double time() const { return time_; }
  double behind() const { return behind_; }
  // Returns what is seen of a state, always the same one, which must outlive the instant. A state
  // between steps is made on first use, and shared by copies.
  const State& seen(const State& state) const;

 private:
  static constexpr double rounding = 1e-6;

  double time_;
  double behind_;
  std::shared_ptr<State> between_ = std::make_shared<State>();
};

}  // namespace hackle
