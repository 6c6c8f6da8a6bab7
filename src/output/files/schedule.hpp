// SPDX-License-Identifier: MIT
// The times at which an output sees the state.
#pragma once

#include <cstdint>

#include "solver/view.hpp"

namespace hackle {

// The times start + k * every, k = 0, 1, ...; each is served by the nearest step, so that the times
// never drift, whatever the step.
class Schedule {
 public:
  // Starts at the present time. Throws Error (refused) if `every`, in s, is less than a step;
  // `output` names the caller.
  Schedule(const char* output, double every, const View& view);

  bool reached(const View& view) const;
  // A step before which it is not reached.
  std::int64_t next_due(const View& view) const;
  // Returns how many times lie between the start and `until`, s; at most `max_more` of them to
  // come.
  std::int64_t moments(double until, std::int64_t max_more) const;
  // Advances to the next time that has not passed: quasi-static loading may pass several at once.
  void advance(const View& view);

 private:
  double start_;
  double every_;
  std::int64_t next_ = 0;
};

}  // namespace hackle
