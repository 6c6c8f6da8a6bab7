// SPDX-License-Identifier: MIT
#include "output/files/schedule.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "solver/aim.hpp"

namespace hackle {
namespace {

constexpr double rounding = 1e-6;  // of a step

}  // namespace

Schedule::Schedule(const char* output, double every, const View& view)
    : start_(view.time()), every_(std::max(every, view.dt())) {
  if (!(every > 0.0) || !std::isfinite(every))
    throw Error(ErrorKind::refused,
                fmt::format("{}: every is {} s, it must be above 0 s", output, every));
  if (every < view.dt() * (1.0 - 1e-9))
    remark_ = fmt::format("{}: every is {}, less than the step of {}: it takes every step", output,
                          quantity(every, "s"), quantity(view.dt(), "s"));
}

bool Schedule::reached(const View& view) const {
  return view.time() + rounding * view.dt() >= next();
}

double Schedule::moment(const View& view) const {
  return next() > view.time() - view.dt() ? next() : view.time();
}

std::int64_t Schedule::next_due(const View& view) const {
  constexpr double margin = 1.0;  // for rounding
  const double steps = (next() - view.time()) / view.dt() - margin;
  return view.state().step + static_cast<std::int64_t>(std::clamp(steps, 0.0, max_steps));
}

void Schedule::advance(const View& view) {
  const double passed = (view.time() + rounding * view.dt() - start_) / every_;
  next_ = std::max(next_, static_cast<std::int64_t>(std::floor(passed))) + 1;
}

std::int64_t Schedule::moments(double until, std::int64_t max_more) const {
  constexpr double countless = 1e18;
  const double all = std::floor((until - start_) / every_ + 1e-9) + 1.0;
  const double more = std::min(all - static_cast<double>(next_), countless);
  if (!(more > 0.0)) return next_;
  return next_ + std::min(static_cast<std::int64_t>(more), max_more);
}

}  // namespace hackle
