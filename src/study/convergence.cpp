// SPDX-License-Identifier: MIT
#include "study/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "study/moments.hpp"

namespace hackle {
namespace {

using enum RefinedBy;

constexpr auto horizons_per_spacing = std::to_array({3.0, 4.0, 6.0, 8.0});

// A level that is planned; its cost is a multiple of that of the script as written.
struct Planned {
  std::string name;
  Settings settings;
  double cost = 1.0;
};

// Where the script has an option of the same name, that one too.
Settings with_own_options(const Settings& settings, const std::set<std::string>& declared) {
  constexpr std::string_view prefix = "simulate.";
  Settings all = settings;
  for (const auto& [key, value] : settings)
    if (const std::string own = key.substr(prefix.size()); declared.contains(own)) all[own] = value;
  return all;
}

// In two dimensions nodes grow with 1/spacing^2 and steps with 1/spacing.
Planned planned_delta(const SceneNumerics& scene, double factor) {
  const double spacing = scene.spacing * factor;
  return {quantity(spacing * scene.m(), "m"), joined(scene.own_step(), spaced(spacing, scene.m())),
          std::pow(factor, -3.0)};
}

// Bonds per node grow with m^2 besides.
Planned planned_m(const SceneNumerics& scene, double m) {
  return {fmt::format("m = {:.3g}", m), joined(scene.own_step(), spaced(scene.horizon / m, m)),
          std::pow(m / scene.m(), 5.0)};
}

// A step that the script sets in seconds is halved; otherwise the share of the stability limit is.
Planned planned_step(const SceneNumerics& scene, double factor) {
  const bool is_set = scene.has_step;
  const double step = (is_set ? scene.dt : scene.safety) * factor;
  return {is_set ? quantity(step, "s") : fmt::format("safety {:.3g}", step),
          simulated(is_set ? "step" : "safety", shortest(step)), 1.0 / factor};
}

std::vector<Planned> plan_of(RefinedBy by, const SceneNumerics& scene,
                             const ConvergenceOptions& options) {
  std::vector<Planned> plan;
  if (by == m) {
    for (const double count : horizons_per_spacing) plan.push_back(planned_m(scene, count));
    return plan;
  }
  // The step as written is as large as it may be.
  const int coarser = by == delta ? 1 : 0;
  for (int k = -coarser; k < options.levels - coarser; ++k)
    plan.push_back(by == delta ? planned_delta(scene, std::pow(options.ratio, -k))
                               : planned_step(scene, std::pow(2.0, -k)));
  return plan;
}

double size_of(RefinedBy by, const SceneNumerics& scene) {
  return by == delta ? scene.horizon : by == m ? scene.spacing : scene.dt;
}

void run_axis(CaseRunner& runner, const ConvergenceOptions& options, const ConvergenceStudy& study,
              ConvergenceAxis& axis) {
  std::vector<Case> cases;
  std::vector<std::string> names;
  for (Planned& level : plan_of(axis.by, study.numerics, options)) {
    const double expected = level.cost * study.written.cpu;
    if (expected > options.budget && level.cost > 1.0) {
      axis.left_out.push_back({level.name, expected});
      continue;
    }
    names.push_back(level.name);
    cases.push_back({.settings = with_own_options(level.settings, options.declared),
                     .sample_at = study.sample_at});
  }
  // The longest first: short ones then fill the threads that are left.
  std::vector<Case> reversed(cases.rbegin(), cases.rend());
  std::vector<Outcome> outcomes = runner.run(reversed, fmt::format("{}", name_of(axis.by)));
  std::ranges::reverse(outcomes);
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (!outcomes[k].finished()) {
      axis.failed.push_back(fmt::format("{}: {}", names[k], outcomes[k].reason));
      continue;
    }
    const SceneNumerics scene = numerics_of(outcomes[k]);
    const double size = size_of(axis.by, scene);
    // A step may be cut to what the times of outputs allow, and be the same as the one before.
    if (!axis.levels.empty() && size >= axis.levels.back().size * (1.0 - 1e-9)) continue;
    const std::string name = axis.by == step ? quantity(scene.dt, "s") : names[k];
    axis.levels.push_back({std::move(outcomes[k]), size, name, scene.spacing, scene.dt});
  }
}

// A number's changes have a sign.
std::optional<LevelChange> change_of(const QuantityValue& one, const QuantityValue& other,
                                     const QuantityRow& row) {
  const auto size = distance(one, other, row);
  if (!size) return std::nullopt;
  const bool falls = one.number && *other.number < *one.number;
  return LevelChange{*size, falls ? -1 : 1};
}

// Places are known to a cell of the lattice, here the finest, as they are means of many; times to a
// step.
std::vector<double> resolutions_of(const std::vector<Level>& levels, const QuantityRow& row) {
  const bool is_place = row.unit == "m";
  std::vector<double> all;
  all.reserve(levels.size());
  for (const Level& level : levels)
    all.push_back(is_place ? levels.back().spacing : row.unit == "s" ? level.dt : 0.0);
  return all;
}

void extrapolate(QuantityConvergence& result, const std::vector<double>& sizes) {
  const ObservedOrder& order = result.order;
  const std::size_t fine = sizes.size() - 1;
  if (order.trend == Trend::converges && order.order) {
    const double ratio = sizes[fine - 1] / sizes[fine];
    const auto of = [&](double coarse, double finest) {
      return richardson(coarse, finest, ratio, *order.order);
    };
    const QuantityValue &one = result.values[fine - 1], &other = result.values[fine];
    if (other.number) result.limit = of(*one.number, *other.number);
    if (other.place)
      result.place =
          Vec2(of(one.place->x(), other.place->x()), of(one.place->y(), other.place->y()));
  }
  if (order.uncertainty) {
    const double finest = result.values[fine].number.value_or(0.0);
    if (!has_relative_error(result.row))
      result.gci = order.uncertainty;
    else if (finest != 0.0)
      result.gci = *order.uncertainty / std::abs(finest);
  }
}

// What the finest two levels tell, if they found it.
ObservedOrder order_of_missing(const QuantityConvergence& result,
                               const std::vector<double>& sizes) {
  ObservedOrder order;
  const std::size_t count = sizes.size();
  if (count > 1 && result.values[count - 1].found() && result.distances[count - 2]) {
    const LevelChange last{*result.distances[count - 2]};
    order = observed_order(std::span(sizes).last(2), std::span(&last, 1));
    order.uncertainty.reset();
  }
  order.trend = Trend::missing;
  return order;
}

void fit_exponent(QuantityConvergence& result, const std::vector<double>& sizes) {
  if (result.order.trend != Trend::diverges || result.row.kind != ComparedAs::number) return;
  std::vector<double> numbers;
  for (const QuantityValue& value : result.values) numbers.push_back(*value.number);
  result.exponent = fitted_exponent(sizes, numbers);
}

}  // namespace

std::optional<QuantityConvergence> judged(const std::vector<Level>& levels,
                                          const QuantityRow& row) {
  QuantityConvergence result{.row = row};
  for (const Level& level : levels) result.values.push_back(value_of(level.outcome, row));
  const auto found = [](const QuantityValue& value) { return value.found(); };
  if (std::ranges::none_of(result.values, found)) return std::nullopt;
  for (const QuantityValue& value : result.values)
    result.distances.push_back(distance(value, result.values.back(), row));
  std::vector<double> sizes;
  sizes.reserve(levels.size());
  for (const Level& level : levels) sizes.push_back(level.size);
  if (!std::ranges::all_of(result.values, found)) {
    result.order = order_of_missing(result, sizes);
    return result;
  }
  std::vector<LevelChange> changes;
  for (std::size_t k = 1; k < levels.size(); ++k)
    if (const auto change = change_of(result.values[k - 1], result.values[k], row))
      changes.push_back(*change);
  if (changes.size() + 1 != levels.size()) return result;  // fields without a common place
  const std::vector<double> resolutions = resolutions_of(levels, row);
  result.resolution = resolutions.back();
  result.order = observed_order(sizes, changes, resolutions);
  extrapolate(result, sizes);
  fit_exponent(result, sizes);
  return result;
}

std::string_view refined_name(RefinedBy by) {
  return by == delta ? "horizon" : by == m ? "spacing" : "step";
}

bool has_relative_error(const QuantityRow& row) {
  return row.kind == ComparedAs::number && !row.is_error;
}

bool is_by_distance(const QuantityRow& row) {
  return row.kind == ComparedAs::paths || row.kind == ComparedAs::field;
}

ConvergenceStudy convergence(CaseRunner& runner, const ConvergenceOptions& options) {
  ConvergenceStudy study;
  study.written = finished(runner.run_alone({}, "the script as written"));
  study.numerics = numerics_of(study.written);
  study.sample_at = moment_of_comparison(study.written);
  const auto all = quantity_rows();
  const std::vector<QuantityRow> rows =
      options.quantities.empty() ? std::vector(all.begin(), all.end()) : options.quantities;
  for (const RefinedBy by : options.axes) {
    ConvergenceAxis& axis = study.axes.emplace_back();
    axis.by = by;
    run_axis(runner, options, study, axis);
    for (const QuantityRow& row : rows)
      if (auto result = judged(axis.levels, row))
        axis.quantities.push_back(*std::move(result));
      else
        axis.absent.push_back(row);
  }
  study.runs = runner.runs();
  return study;
}

}  // namespace hackle
