// SPDX-License-Identifier: MIT
// What movies cost, and what they hide: their cadence and their size.
#pragma once

#include <cstdint>
#include <vector>

#include "study/case_runner.hpp"
#include "study/trade_score.hpp"

namespace hackle {

// A run with all that the script leaves behind. What it computes is the same as without.
struct PictureCost {
  Settings settings;  // of its movies
  Outcome outcome;
  double more = 0.0;             // s of CPU time above that of the run without
  std::uint64_t file_bytes = 0;  // of all that it left
  // "seen.time", s: from a frame to the next, by which an event may be seen late; "seen.place", m:
  // the length of a pixel, and the way of the fastest tip in that time. Empty for the script's own
  // movies, of whose options a run does not tell.
  Errors errors;
  double error = 0.0;     // over 1 % of the duration and a horizon, root mean square
  bool on_front = false;  // among these
};

// Runs the script with its movies as they are, with other cadences and other widths, with the
// settings of `plain`, a run without pictures. Empty if it makes no movie. Throws what CaseRunner
// throws.
std::vector<PictureCost> picture_costs(CaseRunner& runner, const Outcome& plain);

}  // namespace hackle
