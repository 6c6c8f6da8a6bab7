// SPDX-License-Identifier: MIT
// One way to solve a scene, and how far its results are from those of the reference.
#pragma once

#include "study/case.hpp"
#include "study/trade_score.hpp"

namespace hackle {

struct TradeRun {
  Settings settings;  // other than the script's own
  Outcome outcome;
  Errors errors;       // against the reference
  double error = 0.0;  // all of them in one number, see score(); infinite if it did not finish
  bool on_front = false;
};

}  // namespace hackle
