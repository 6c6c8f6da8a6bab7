// SPDX-License-Identifier: MIT
// The expected cost of a run, before it is carried out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/run/prospect.hpp"
#include "scene/forecast.hpp"
#include "solver/simulation.hpp"

namespace hackle {

struct Rehearsal {
  std::int64_t nodes = 0;
  std::int64_t bonds = 0;
  double memory = 0.0;    // bytes
  double dt = 0.0;        // s
  double dt_limit = 0.0;  // s
  std::int64_t steps = 0;
  double time = 0.0;                // simulated time, s
  double step_seconds = 0.0;        // wall time per step, measured on a moving, unbroken plate; 0:
                                    // too large to be measured
  int increments = 0;               // of quasi-static loading, whose wall time cannot be estimated
  Forecast forecast;                // for the episode in which most may break
  std::vector<std::string> doubts;  // facts that cannot be judged without computing
  bool looked = false;              // the script has read results
};

// Rehearses a simulation in which nothing has been computed.
Rehearsal rehearse(const Simulation& simulation, const Prospect& prospect);

// Returns several lines.
std::string describe(const Rehearsal& rehearsal);

}  // namespace hackle
