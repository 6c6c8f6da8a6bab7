// SPDX-License-Identifier: MIT
#include "study/budget.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "study/quantity.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {
namespace {

constexpr std::array steps{2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0};
constexpr double finest_m = 8.0;  // half the spacing then is the finest that the lattice takes
constexpr double coarsest_side = 10.0;  // spacings on the shorter side, at a step of 1
constexpr double fifth_digit_of_E = 1e-5;
constexpr double usual_m = 4.0;  // of a horizon that follows from the spacing

QuantityRow path_row() {
  return *quantity_named("tip.path");
}

bool is_cracked(const Outcome& outcome) {
  return value_of(outcome, path_row()).found();
}

// Infinite if only one of them has cracked, or one did not finish.
double distance_of(const Outcome& one, const Outcome& other) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (!one.finished() || !other.finished()) return infinite;
  return distance(value_of(one, path_row()), value_of(other, path_row()), path_row())
      .value_or(infinite);
}

class Trials {
 public:
  Trials(CaseRunner& runner, const BudgetCalibration& calibration, const BudgetOptions& options)
      : runner_(&runner),
        calibration_(&calibration),
        options_(&options),
        spacings_(budget_spacings(options)) {
    budget_.within = options.within;
    if (!options.precision.empty()) budget_.precision = options.precision;
  }

  ErrorBudget made() {
    find_spacing();
    look_for_chaos();
    if (options_->verify) verify();
    return std::move(budget_);
  }

 private:
  Settings settings_of(double spacing, const std::string& precision) const {
    return joined(simulated("spacing", shortest(spacing)), simulated("precision", precision));
  }

  Outcome tried(const Settings& settings) {
    Outcome outcome = runner_->run_alone({.settings = settings}, "trial for the error budget");
    ++budget_.trials;
    budget_.trial_cpu += outcome.cpu;
    return outcome;
  }

  double horizon_at(std::size_t level) const {
    return options_->horizon.value_or(usual_m * spacings_[level]);
  }
  double least_at(std::size_t level) const { return calibration_->least * horizon_at(level); }

  // What can be hoped for: a given horizon sets a limit.
  double goal() const {
    return options_->horizon ? std::max(options_->within, least_at(0)) : options_->within;
  }

  void take(std::size_t level, std::optional<double> expected) {
    level_ = level;
    budget_.spacing = spacings_[level];
    budget_.expected = expected;
  }

  // Whether trials so far say enough; if no setting is good enough, the finest is taken.
  bool settle(std::size_t level) {
    const Outcome &coarse = outcomes_[level - 1], &fine = outcomes_[level];
    if (!is_cracked(fine) && level < min_level_without_cracks) return false;
    budget_.uncracked = !is_cracked(fine) && !is_cracked(coarse);
    const double apart = distance_of(coarse, fine);
    const double of_coarse = std::max(calibration_->of_coarser * apart, least_at(level - 1));
    const double of_fine = std::max(calibration_->of_same * apart, least_at(level));
    if (is_cracked(coarse) && of_coarse <= goal()) {
      take(level - 1, of_coarse);
      return true;
    }
    take(level, std::isfinite(of_fine) ? std::optional(of_fine) : std::nullopt);
    return budget_.uncracked || of_fine <= goal();
  }

  void find_spacing() {
    for (std::size_t level = 0; level < spacings_.size(); ++level) {
      outcomes_.push_back(tried(settings_of(spacings_[level], budget_.precision)));
      if (level > 0 && settle(level)) break;
    }
    if (std::ranges::none_of(outcomes_, &Outcome::finished)) finished(outcomes_.back());
    if (outcomes_.size() == 1) take(0, std::nullopt);
    if (budget_.uncracked) budget_.expected.reset();
  }

  // Of two runs that differ in nothing known. A coarser trial than the choice suffices.
  void look_for_chaos() {
    if (budget_.uncracked) return;
    const std::size_t level = level_ > 0 && is_cracked(outcomes_[level_ - 1]) ? level_ - 1 : level_;
    if (!outcomes_[level].finished()) return;
    const double E = numerics_of(outcomes_[level]).E;
    Settings other = settings_of(spacings_[level], budget_.precision);
    other["material.E"] = shortest(E * (1.0 + fifth_digit_of_E));
    budget_.chaotic = distance_of(outcomes_[level], tried(other)) > goal();
    if (budget_.chaotic) budget_.expected.reset();
  }

  void verify() {
    const Outcome finer = runner_->run_alone(
        {.settings = settings_of(0.5 * budget_.spacing, "f64")}, "reference for the error budget");
    const double error = distance_of(outcomes_[level_], finished(finer));
    if (std::isfinite(error)) budget_.measured = error;
  }

  static constexpr std::size_t min_level_without_cracks = 3;

  CaseRunner* runner_;
  const BudgetCalibration* calibration_;
  const BudgetOptions* options_;
  std::vector<double> spacings_;
  std::vector<Outcome> outcomes_;  // by level
  std::size_t level_ = 0;          // chosen
  ErrorBudget budget_;
};

}  // namespace

BudgetCalibration budget_calibration() {
  const auto path = data_file("assets/error_budget.json");
  const auto json = nlohmann::json::parse(read_text(path), nullptr, false);
  if (!json.is_object() || !json.contains("levels"))
    throw Error(ErrorKind::files, fmt::format("'{}' is damaged", path.string()),
                "install hackle again");
  BudgetCalibration calibration{.of_same = json.value("of_same", 1.0),
                                .of_coarser = json.value("of_coarser", 2.0),
                                .least = json.value("least_horizons", 1.0),
                                .levels = {}};
  for (const auto& level : json["levels"])
    calibration.levels.push_back({level.value("m", 0.0), level.value("error_horizons", 0.0)});
  return calibration;
}

std::vector<double> budget_spacings(const BudgetOptions& options) {
  std::vector<double> all;
  for (const double step : steps) {
    if (options.horizon && step > finest_m) break;
    const double spacing =
        options.horizon ? *options.horizon / step : options.side / (coarsest_side * step);
    if (!options.max_spacing || spacing <= *options.max_spacing * (1.0 + 1e-9))
      all.push_back(spacing);
  }
  if (all.empty()) all.push_back(*options.max_spacing);
  return all;
}

ErrorBudget budget_from(const BudgetCalibration& calibration, const BudgetOptions& options) {
  ErrorBudget budget{.within = options.within};
  if (!options.precision.empty()) budget.precision = options.precision;
  for (const double spacing : budget_spacings(options)) {
    const double horizon = options.horizon.value_or(usual_m * spacing);
    // Of levels between those that were measured, the coarser one holds.
    double error = std::numeric_limits<double>::infinity();
    for (const auto& level : calibration.levels)
      if (level.m <= horizon / spacing * (1.0 + 1e-9))
        error = std::max(level.error, calibration.least) * horizon;
    budget.spacing = spacing;
    budget.expected = std::isfinite(error) ? std::optional(error) : std::nullopt;
    if (budget.is_met()) break;
  }
  return budget;
}

ErrorBudget budget_by_trials(CaseRunner& runner, const BudgetCalibration& calibration,
                             const BudgetOptions& options) {
  return Trials(runner, calibration, options).made();
}

}  // namespace hackle
