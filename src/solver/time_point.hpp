// SPDX-License-Identifier: MIT
// Where a run stands in time.
#pragma once

#include <cstdint>

#include "solver/aim.hpp"
#include "solver/clock.hpp"

namespace hackle {

struct TimePoint {
  std::int64_t step = 0;
  Clock clock;
  Aim aim;            // to where it is on its way
  double time = 0.0;  // s, at which it is seen; see Instant
};

}  // namespace hackle
