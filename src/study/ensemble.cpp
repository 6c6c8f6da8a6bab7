// SPDX-License-Identifier: MIT
#include "study/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

constexpr int times_of_curve = 40;
constexpr double settled_deviation = 0.01;

// Between -1 and 1, differently for each number, evenly for any count of them.
double spread(int number) {
  constexpr double golden = 0.6180339887498949;
  return 2.0 * std::fmod(number * golden, 1.0) - 1.0;
}

// The first run is the script as written, unless its strength is scattered.
Settings changed(const SceneNumerics& scene, const EnsembleOptions& options, int number) {
  if (options.change == Change::stiffness) {
    if (number == 0) return {};
    if (options.size == 0.0) return last_bits(scene, number);
    return {{"material.E", shortest(scene.E * (1.0 + options.size * spread(number)))}};
  }
  Settings settings{{"scatter.seed", fmt::format("{}", number + 1)}};
  if (options.change == Change::strength) settings["scatter.deviation"] = shortest(options.size);
  return settings;
}

void sort_out(std::vector<Outcome> outcomes, Ensemble& all) {
  for (Outcome& outcome : outcomes)
    (outcome.finished() ? all.runs : all.failed).push_back(std::move(outcome));
  if (all.runs.size() >= 2) return;
  const std::string why = all.failed.empty() ? "" : ": " + all.failed.front().reason;
  throw Error(ErrorKind::run_failed,
              fmt::format("of {} runs {} finished, an ensemble needs two{}",
                          all.runs.size() + all.failed.size(), all.runs.size(), why),
              "hackle run tells more");
}

// Every two runs are compared; only the first time they differ, and how far at the end, is kept.
void compare_all(Ensemble& all) {
  const Nearness near{all.within};
  constexpr double end = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < all.paths.size(); ++a)
    for (std::size_t b = a + 1; b < all.paths.size(); ++b) {
      throw_if_interrupted();
      const auto place = parting(all.paths[a], all.paths[b], near);
      if (place && (!all.parting || place->time < all.parting->time)) all.parting = place;
      all.apart = std::max(all.apart, distance_at(end, all.paths[a], all.paths[b], near));
    }
}

double middle_of(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  return *middle;
}

void follow_first(Ensemble& all) {
  const Nearness near{all.within};
  for (int k = 1; k <= times_of_curve; ++k) {
    throw_if_interrupted();
    const double time = all.scene.duration * k / times_of_curve;
    std::vector<double> distances;
    for (std::size_t run = 1; run < all.paths.size(); ++run)
      distances.push_back(distance_at(time, all.paths.front(), all.paths[run], near));
    all.median.emplace_back(time, middle_of(distances));
    all.largest.emplace_back(time, std::ranges::max(distances));
  }
}

QuantityStatistic statistic_of_row(const QuantityRow& row, const std::vector<Outcome>& runs) {
  QuantityStatistic one{.row = row, .values = {}, .statistic = {}};
  std::vector<double> found;
  for (const Outcome& run : runs) {
    const std::optional<double> number = value_of(run, row).number;
    one.values.push_back(number);
    if (number) found.push_back(*number);
  }
  one.statistic = statistic_of(found);
  return one;
}

}  // namespace

bool QuantityStatistic::is_settled() const {
  const bool all = statistic.count == static_cast<int>(values.size());
  return all && statistic.sd <= settled_deviation * std::abs(statistic.mean);
}

bool Ensemble::has_cracks() const {
  return std::ranges::any_of(paths, [](const TimedPaths& one) { return !one.empty(); });
}

std::vector<QuantityRow> ensemble_quantities() {
  return quantities_named({"first_bond.time", "fork.time", "fork.angle", "arrival.time",
                           "tip.speed", "branches", "crack.length", "energy.broken", "fragments",
                           "fragments.largest", "fragments.median"});
}

Ensemble ensemble_of(const SceneNumerics& scene, const EnsembleOptions& options,
                     std::vector<Outcome> runs) {
  Ensemble all{.change = options.change,
               .size = options.size,
               .of_bits = options.change == Change::stiffness && options.size == 0.0,
               .scene = scene,
               .within = options.within.value_or(scene.horizon)};
  if (all.of_bits) all.size = static_cast<double>(runs.size() - 1) * last_bit(scene);
  sort_out(std::move(runs), all);
  std::ranges::transform(all.runs, std::back_inserter(all.paths), timed_paths_of);
  compare_all(all);
  follow_first(all);
  for (const QuantityRow& row :
       options.quantities.empty() ? ensemble_quantities() : options.quantities)
    all.quantities.push_back(statistic_of_row(row, all.runs));
  if (all.runs.front().told.contains("plate"))
    all.frequency = crack_frequency(all.paths, all.runs.front().told["plate"], 0.5 * scene.horizon);
  return all;
}

Ensemble ensemble(CaseRunner& runner, const EnsembleOptions& options) {
  const SceneNumerics scene = numerics_of(finished(runner.run_alone({}, "as written")));
  std::vector<Case> cases;
  cases.reserve(static_cast<std::size_t>(options.runs));
  for (int number = 0; number < options.runs; ++number)
    cases.push_back({.settings = changed(scene, options, number)});
  return ensemble_of(scene, options, runner.run(cases, "runs"));
}

}  // namespace hackle
