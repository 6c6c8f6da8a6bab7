// SPDX-License-Identifier: MIT
#include "render/diagram/scaled_axis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "render/overlay/overlay_text.hpp"
#include "render/overlay/ticks.hpp"

namespace hackle {
namespace {

// Returns a range that is wide enough for ticks.
Ends opened(Ends ends, bool logarithmic) {
  const double size = std::max(std::abs(ends.min), std::abs(ends.max));
  if (ends.max - ends.min > 1e-9 * size) return ends;
  if (logarithmic) return {0.5 * ends.min, 2.0 * ends.max};
  const double half = size > 0.0 ? 0.1 * size : 1.0;
  return {ends.min - half, ends.max + half};
}

// Returns a range that reaches 0 where most of the way from there is seen anyway.
Ends with_zero(Ends ends) {
  constexpr double near = 0.5;
  if (ends.min > 0.0 && ends.min < near * ends.max) ends.min = 0.0;
  if (ends.max < 0.0 && ends.max > near * ends.min) ends.max = 0.0;
  return ends;
}

}  // namespace

ScaledAxis::ScaledAxis(const DiagramAxis& axis, const Ends& seen, int intervals, bool encloses)
    : logarithmic_(axis.logarithmic), ends_(axis.range.value_or(seen)) {
  if (!axis.range) find_ends(seen, intervals, encloses);
  if (ticks_.empty() && logarithmic_) ticks_ = decades(ends_.min, ends_.max, intervals);
  // An axis within a decade has neat values along it too.
  if (ticks_.size() < 2) ticks_ = neat_values(ends_.min, ends_.max, intervals);
  const PrefixedUnit unit =
      axis_unit(std::max(std::abs(ends_.min), std::abs(ends_.max)), axis.unit);
  std::vector<double> shown = ticks_;
  for (double& value : shown) value /= unit.factor;
  texts_ = tick_texts(shown);
  const std::string name = printed_unit(unit.name);
  heading_ = name.empty() ? axis.name : fmt::format("{} ({})", axis.name, name);
}

void ScaledAxis::find_ends(const Ends& seen, int intervals, bool encloses) {
  ends_ = opened(logarithmic_ ? seen : with_zero(seen), logarithmic_);
  if (logarithmic_ && encloses) {
    ends_ = {std::pow(10.0, std::floor(std::log10(ends_.min))),
             std::pow(10.0, std::ceil(std::log10(ends_.max)))};
  } else if (encloses) {
    ticks_ = enclosing_values(ends_.min, ends_.max, intervals);
    if (!ticks_.empty())
      ends_ = {std::min(ends_.min, ticks_.front()), std::max(ends_.max, ticks_.back())};
  }
}

bool ScaledAxis::holds(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0.0);
}

double ScaledAxis::share(double value) const {
  if (logarithmic_) return std::log(value / ends_.min) / std::log(ends_.max / ends_.min);
  return (value - ends_.min) / (ends_.max - ends_.min);
}

}  // namespace hackle
