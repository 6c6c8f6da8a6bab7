// SPDX-License-Identifier: MIT
#include "output/prospect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hackle {
namespace {

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
  judge(simulation, simulation.time(), true);
}

void Prospect::exchange_loads(const Simulation& simulation, const Loads& loads) {
  go_on();
  if (simulation.plate().loads.supports.size() != loads.supports.size()) since_ = simulation.time();
  stored_ = std::max(stored_, std::exchange(acted_, 0.0));
}

Forecast Prospect::worst(const Simulation& simulation) const {
  if (judged_) return worst_;
  return forecast_of(simulation, {.begin = simulation.time(), .end = simulation.time()});
}

void Prospect::go_on() {
  if (looked_) doubt("what the script does after it has looked at results, which are not there");
}

void Prospect::judge(const Simulation& simulation, double end, bool slow) {
  go_on();
  rests_ = rests_ || slow;
  const Forecast found = forecast_of(
      simulation,
      {.begin = simulation.time(), .end = end, .since = since_, .slow = slow, .stored = stored_});
  acted_ = std::max(acted_, slow ? found.stress : found.stress / overshoot);
  const bool sampled = worst_.sampled || found.sampled;
  if (!judged_ || found.release_rate > worst_.release_rate) worst_ = found;
  worst_.sampled = sampled;
  judged_ = true;
}

}  // namespace hackle
