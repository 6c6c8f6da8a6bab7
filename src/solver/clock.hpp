// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hackle {

// The time of steps, counted from the last time that was not reached by steps.
struct Clock {
  double moment = 0.0;     // s
  std::int64_t since = 0;  // the step at that time

  // Returns the time in the middle of a step for `share` 0.5, s.
  double time(std::int64_t step, double share, double dt) const {
    return moment + (static_cast<double>(step - since) + share) * dt;
  }
  bool operator==(const Clock&) const = default;
};

}  // namespace hackle
