// SPDX-License-Identifier: MIT
#include "study/trade_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hackle {
namespace {

bool has_all(const Settings& settings, const Settings& part) {
  return std::ranges::all_of(part, [&](const auto& one) {
    const auto at = settings.find(one.first);
    return at != settings.end() && at->second == one.second;
  });
}

const TradeRun* run_of(const Settings& settings, const std::vector<TradeRun>& runs) {
  const auto run = std::ranges::find(runs, settings, &TradeRun::settings);
  return run == runs.end() ? nullptr : &*run;
}

}  // namespace

TradeForecast forecast_of(const Settings& settings, const std::vector<TradeAxis>& axes,
                          const std::vector<TradeRun>& runs) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const TradeRun& as_written = runs.front();
  TradeForecast forecast{as_written.outcome.cpu, as_written.error};
  for (const TradeAxis& axis : axes)
    for (const Settings& value : axis.values) {
      if (!has_all(settings, value)) continue;
      const TradeRun* run = run_of(value, runs);
      if (!run || !run->outcome.finished()) return {infinity, infinity};
      forecast.cost *= run->outcome.cpu / as_written.outcome.cpu;
      if (as_written.error > 0.0) forecast.error *= std::min(1.0, run->error / as_written.error);
    }
  return forecast;
}

bool is_of_model(const Settings& settings, const std::vector<TradeAxis>& axes) {
  return std::ranges::any_of(
      axes, [&](const TradeAxis& axis) { return axis.of_model && axis.has(settings); });
}

bool is_hopeless(const TradeForecast& forecast, const std::vector<TradeAxis>& axes,
                 const std::vector<TradeRun>& runs, double most) {
  constexpr double clearly_cheaper = 0.8;
  if (!(forecast.cost <= most)) return true;
  return std::ranges::any_of(runs, [&](const TradeRun& run) {
    return run.outcome.finished() && !is_of_model(run.settings, axes) &&
           run.outcome.cpu < clearly_cheaper * forecast.cost && run.error <= forecast.error;
  });
}

Settings surest(const std::vector<TradeAxis>& axes, const std::vector<TradeRun>& runs) {
  constexpr double clearly = 0.95;
  Settings sure;
  for (const TradeAxis& axis : axes) {
    if (axis.of_lattice || axis.of_model) continue;
    const TradeRun* best = nullptr;
    for (const TradeRun& run : runs)
      if (axis.has(run.settings) && run.error < clearly * runs.front().error &&
          (!best || run.error < best->error))
        best = &run;
    if (best) sure = joined(sure, best->settings);
  }
  return sure;
}

Settings fast_arithmetic(const std::vector<TradeAxis>& axes, const std::vector<TradeRun>& runs) {
  constexpr double little = 1.1;
  const TradeRun& as_written = runs.front();
  Settings fast;
  for (const TradeAxis& axis : axes) {
    if (!axis.exact_by_itself) continue;
    const TradeRun* cheapest = &as_written;
    for (const TradeRun& run : runs)
      if (axis.has(run.settings) && run.error <= little * as_written.error &&
          run.outcome.cpu < cheapest->outcome.cpu)
        cheapest = &run;
    fast = joined(fast, cheapest->settings);
  }
  return fast;
}

}  // namespace hackle
