// SPDX-License-Identifier: MIT
// When an output wants to see the state.
#pragma once

#include <cstdint>

#include "solver/simulation.hpp"

namespace hackle {

// The moments start + k * every, k = 0, 1, ...; each is served by the step nearest to it, so that
// times never drift whatever the step is.
class Schedule {
 public:
  // Starts now. Throws Error (refused) when `every`, in s, is less than a step; `output` names who
  // asks.
  Schedule(const char* output, double every, const Simulation& simulation);

  bool reached(const Simulation& simulation) const;
  // A step before which it is not reached.
  std::int64_t next_due(const Simulation& simulation) const;
  // How many moments there are from the start until `until`, s; those to come at most `max_more`.
  std::int64_t moments(double until, std::int64_t max_more) const;
  // To the next moment that has not passed: slow loading may go by several at once.
  void advance(const Simulation& simulation);

 private:
  double start_;
  double every_;
  std::int64_t next_ = 0;
};

}  // namespace hackle
