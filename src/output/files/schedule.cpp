// SPDX-License-Identifier: MIT
#include "output/files/schedule.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {

Schedule::Schedule(const char* output, double every, const Simulation& simulation)
    : start_(simulation.time()), every_(every) {
  if (every >= simulation.dt() && std::isfinite(every)) return;
  throw Error(ErrorKind::refused,
              fmt::format("{}: every is {}, less than one time step of {}", output,
                          quantity(every, "s"), quantity(simulation.dt(), "s")),
              fmt::format("take {} or more", quantity(simulation.dt(), "s")));
}

bool Schedule::reached(const Simulation& simulation) const {
  const double moment = start_ + static_cast<double>(next_) * every_;
  return simulation.time() + 0.5 * simulation.dt() > moment;
}

std::int64_t Schedule::next_due(const Simulation& simulation) const {
  constexpr double margin = 2.0;  // half a step, and rounding
  const double moment = start_ + static_cast<double>(next_) * every_;
  const double steps = (moment - simulation.time()) / simulation.dt() - margin;
  return simulation.state().step + static_cast<std::int64_t>(std::clamp(steps, 0.0, max_steps));
}

void Schedule::advance(const Simulation& simulation) {
  const double passed = (simulation.time() - 0.5 * simulation.dt() - start_) / every_;
  next_ = std::max(next_ + 1, static_cast<std::int64_t>(std::ceil(passed)));
}

std::int64_t Schedule::moments(double until, std::int64_t max_more) const {
  constexpr double countless = 1e18;
  const double all = std::floor((until - start_) / every_ + 1e-9) + 1.0;
  const double more = std::min(all - static_cast<double>(next_), countless);
  if (!(more > 0.0)) return next_;
  return next_ + std::min(static_cast<std::int64_t>(more), max_more);
}

}  // namespace hackle
