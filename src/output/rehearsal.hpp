// SPDX-License-Identifier: MIT
// What a run will take, before it is carried out.
#pragma once

#include <cstdint>
#include <string>

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
  Forecast forecast;
};

// Of a simulation in which nothing has been computed, for so many steps.
Rehearsal rehearse(const Simulation& simulation, std::int64_t steps);

// Several lines.
std::string describe(const Rehearsal& rehearsal);

}  // namespace hackle
