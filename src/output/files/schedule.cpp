// SPDX-License-Identifier: MIT
#include "output/files/schedule.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "solver/aim.hpp"

namespace hackle {

Schedule::Schedule(const char* output, double every, const View& view)
    : start_(view.time()), every_(every) {
  if (every >= view.dt() && std::isfinite(every)) return;
  throw Error(ErrorKind::refused,
              fmt::format("{}: every is {}, less than one time step of {}", output,
                          quantity(every, "s"), quantity(view.dt(), "s")),
              fmt::format("take {} or more", quantity(view.dt(), "s")));
}

bool Schedule::reached(const View& view) const {
  const double moment = start_ + static_cast<double>(next_) * every_;
  return view.time() + 0.5 * view.dt() > moment;
}

std::int64_t Schedule::next_due(const View& view) const {
  constexpr double margin = 2.0;  // half a step, and rounding
  const double moment = start_ + static_cast<double>(next_) * every_;
  const double steps = (moment - view.time()) / view.dt() - margin;
  return view.state().step + static_cast<std::int64_t>(std::clamp(steps, 0.0, max_steps));
}

void Schedule::advance(const View& view) {
  const double passed = (view.time() - 0.5 * view.dt() - start_) / every_;
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
