// SPDX-License-Identifier: MIT
// What a run will take, before it is carried out.
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
  double time = 0.0;          // to be simulated, s
  double step_seconds = 0.0;  // wall time of a step as tried on a plate that moves and is whole; 0:
                              // too large to be tried
  int increments = 0;         // of slow loading, whose wall time is not known beforehand
  Forecast forecast;          // of the moment at which most may break
  std::vector<std::string> doubts;  // what cannot be judged without computing
  bool looked = false;              // the script has looked at results
};

// Of a simulation in which nothing has been computed.
Rehearsal rehearse(const Simulation& simulation, const Prospect& prospect);

// Several lines.
std::string describe(const Rehearsal& rehearsal);

}  // namespace hackle
