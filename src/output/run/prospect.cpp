// SPDX-License-Identifier: MIT
#include "output/run/prospect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

// For a script that is only checked; more would take weeks.
constexpr std::int64_t max_rehearsed = 1'000'000'000;

Forecast forecast_of(const Simulation& simulation, const Episode& episode) {
  return forecast(simulation.plate(), episode, simulation.numerics().horizon_or_default());
}

}  // namespace

void Prospect::run(const Simulation& simulation, double end) {
  judge(simulation, end, false);
  steps_ +=
      static_cast<std::int64_t>(std::ceil(end / simulation.dt() - 1e-9)) - simulation.state().step;
}

void Prospect::load_slowly(const Simulation& simulation, double end, int increments) {
  judge(simulation, end, true);
  increments_ += increments;
}

void Prospect::relax(const Simulation& simulation) {
  judge(simulation, simulation.time_of_step(), true);
}

void Prospect::exchange_loads(const Simulation& simulation, const Loads& loads) {
  go_on();
  if (simulation.plate().loads.supports.size() != loads.supports.size())
    since_ = simulation.time_of_step();
  stored_ = std::max(stored_, std::exchange(acted_, 0.0));
}

void Prospect::arrive(Simulation& simulation) {
  State state = simulation.state();
  state.step = simulation.last_step();
  run(simulation, simulation.time_at(state.step));
  if (steps_ > max_rehearsed)
    throw Error(ErrorKind::refused,
                fmt::format("check: more than {} steps are asked for and there is no end",
                            grouped(max_rehearsed)),
                "the script may wait for what only happens when it is run");
  simulation.restore(std::move(state));
}

// Slow loading takes no step.
void Prospect::arrive_slowly(Simulation& simulation, double duration, int increments) {
  State state = simulation.state();
  state.clock = {simulation.time_of_step() + duration, state.step};
  load_slowly(simulation, state.clock.moment, increments);
  simulation.restore(std::move(state));
}

Forecast Prospect::worst(const Simulation& simulation) const {
  if (judged_) return worst_;
  return forecast_of(simulation,
                     {.begin = simulation.time_of_step(), .end = simulation.time_of_step()});
}

void Prospect::go_on() {
  if (looked_) doubt("what the script does after it has looked at results, which are not there");
}

void Prospect::judge(const Simulation& simulation, double end, bool slow) {
  go_on();
  rests_ = rests_ || slow;
  const Forecast found = forecast_of(simulation, {.begin = simulation.time_of_step(),
                                                  .end = end,
                                                  .since = since_,
                                                  .slow = slow,
                                                  .stored = stored_});
  acted_ = std::max(acted_, slow ? found.stress : found.stress / overshoot);
  const bool sampled = worst_.sampled || found.sampled;
  if (!judged_ || found.release_rate > worst_.release_rate) worst_ = found;
  worst_.sampled = sampled;
  judged_ = true;
}

}  // namespace hackle
