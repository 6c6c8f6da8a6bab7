// SPDX-License-Identifier: MIT
#include "output/report/error_budget.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"

namespace hackle {
namespace {

std::string expectation_of(const ErrorBudget& budget) {
  if (budget.uncracked) return "no crack grows in the trials, nothing can be expected";
  if (budget.chaotic)
    return "chaotic: a change of the stiffness by 1e-5 moves paths farther than that, see hackle "
           "study ensemble";
  if (!budget.expected) return "nothing can be expected, the finest setting was taken";
  return fmt::format("{} expected{}", quantity(*budget.expected, "m"),
                     budget.is_met() ? ""
                                     : ", no setting is expected to keep it: paths are hardly "
                                       "determined to less than a horizon, a smaller one may");
}

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

std::string describe(const ErrorBudget& budget) {
  const std::string source = budget.trials == 0
                                 ? "from the calibration alone, no script was there to try"
                                 : fmt::format("{} trials, {} of CPU time", budget.trials,
                                               quantity(budget.trial_cpu, "s"));
  return fmt::format(
      "paths within {}: {}{}; spacing {} in {} ({})", quantity(budget.within, "m"),
      expectation_of(budget),
      budget.measured ? fmt::format(", {} measured", quantity(*budget.measured, "m")) : "",
      quantity(budget.spacing, "m"), budget.precision, source);
}

nlohmann::ordered_json to_json(const ErrorBudget& budget) {
  return {{"within_m", budget.within},
          {"spacing_m", budget.spacing},
          {"precision", budget.precision},
          {"expected_m", or_null(budget.expected)},
          {"measured_m", or_null(budget.measured)},
          {"is_met", budget.is_met()},
          {"chaotic", budget.chaotic},
          {"uncracked", budget.uncracked},
          {"trials", budget.trials},
          {"trial_cpu_s", budget.trial_cpu}};
}

}  // namespace hackle
