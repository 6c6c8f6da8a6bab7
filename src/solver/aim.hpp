// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "solver/clock.hpp"

namespace hackle {

inline constexpr double max_steps = 1e15;  // per run; whole numbers up to this are exact

// How far a run is to go. The time asked for is kept exactly, so that durations add up whatever the
// step is.
struct Aim {
  double end_time = 0.0;  // s, asked for
  std::int64_t last_step = 0;

  // The aim after `duration` seconds more, for steps of dt: the first step at or after that time.
  // Throws Error (refused) for a duration below 0 or of more than max_steps.
  Aim after(double duration, const Clock& clock, double dt) const;
};

}  // namespace hackle
