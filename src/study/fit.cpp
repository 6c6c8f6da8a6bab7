// SPDX-License-Identifier: MIT
#include "study/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "study/least_squares.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double of_missing = 100.0;  // sigma

double sigma_of(const Measurement& one, double spacing) {
  if (one.sigma) return *one.sigma;
  if (one.value.place || !one.value.paths.empty()) return spacing;
  if (one.row.kind == ComparedAs::count || *one.value.number == 0.0) return 1.0;
  return 0.01 * std::abs(*one.value.number);
}

// Points are in the units of the ranges.
class FitRuns {
 public:
  FitRuns(CaseRunner& runner, const FitOptions& options) : runner_(runner), options_(options) {}

  void set_sigmas(double spacing) {
    for (const Measurement& one : options_.measurements) sigmas_.push_back(sigma_of(one, spacing));
  }
  const std::vector<double>& sigmas() const { return sigmas_; }

  Settings settings_at(const VectorXd& point) const {
    Settings settings;
    for (std::size_t k = 0; k < options_.parameters.size(); ++k)
      settings[options_.parameters[k].key] =
          options_.parameters[k].range->text(rounded(point[static_cast<Index>(k)], k));
    return settings;
  }

  std::vector<Outcome> run(const std::vector<VectorXd>& points) {
    std::vector<Case> cases;
    cases.reserve(points.size());
    for (const VectorXd& point : points) cases.push_back({.settings = settings_at(point)});
    if (cases.size() == 1) return {runner_.run_alone(cases.front(), "fit")};
    return runner_.run(cases, "fit");
  }

  // Residuals of all measurements, one after the other.
  VectorXd residuals_of(const Outcome& outcome) const {
    Index size = 0;
    for (const Measurement& one : options_.measurements) size += one.size();
    VectorXd all(size);
    Index at = 0;
    for (std::size_t k = 0; k < options_.measurements.size(); ++k) {
      const Measurement& one = options_.measurements[k];
      const auto some = one.residuals(outcome, sigmas_[k]);
      // Its sum of squares does not depend on the number of its residuals.
      const double missing = of_missing / std::sqrt(static_cast<double>(one.size()));
      all.segment(at, one.size()) = some ? *some : VectorXd::Constant(one.size(), missing);
      at += one.size();
    }
    return all;
  }

  bool finds_all(const Outcome& outcome) const {
    return std::ranges::all_of(options_.measurements, [&](const Measurement& one) {
      return value_of(outcome, one.row).found();
    });
  }

 private:
  // Numbers with a reasonable number of digits: a millionth of the range.
  double rounded(double value, std::size_t k) const {
    const ParameterRange& range = *options_.parameters[k].range;
    const double grain =
        std::pow(10.0, std::floor(std::log10(std::abs(range.to - range.from))) - 5.0);
    return std::clamp(std::round(value / grain) * grain, std::min(range.from, range.to),
                      std::max(range.from, range.to));
  }

  CaseRunner& runner_;
  const FitOptions& options_;
  std::vector<double> sigmas_;
};

FitBounds bounds_of(const FitOptions& options) {
  const auto count = static_cast<Index>(options.parameters.size());
  FitBounds bounds{VectorXd(count), VectorXd(count)};
  for (Index k = 0; k < count; ++k) {
    const ParameterRange& range = *options.parameters[static_cast<std::size_t>(k)].range;
    bounds.from[k] = std::min(range.from, range.to);
    bounds.to[k] = std::max(range.from, range.to);
  }
  return bounds;
}

VectorXd start_of(const FitOptions& options, const FitBounds& bounds) {
  VectorXd start = 0.5 * (bounds.from + bounds.to);
  for (std::size_t k = 0; k < options.start.size(); ++k)
    if (options.start[k]) {
      const auto at = static_cast<Index>(k);
      start[at] = std::clamp(*options.start[k] / options.parameters[k].range->factor,
                             bounds.from[at], bounds.to[at]);
    }
  return start;
}

// Points along every parameter that has no given start, and along the diagonal of them all: results
// have many valleys.
std::vector<VectorXd> scan_of(const FitOptions& options, const FitBounds& bounds,
                              const VectorXd& start) {
  constexpr auto shares = std::to_array({0.125, 0.375, 0.625, 0.875});
  const auto is_free = [&](Index k) {
    return static_cast<std::size_t>(k) >= options.start.size() ||
           !options.start[static_cast<std::size_t>(k)];
  };
  std::vector<VectorXd> points;
  for (const double share : shares) {
    VectorXd diagonal = start;
    for (Index k = 0; k < start.size(); ++k) {
      if (!is_free(k)) continue;
      VectorXd point = start;
      diagonal[k] = point[k] = bounds.from[k] + share * (bounds.to[k] - bounds.from[k]);
      points.push_back(std::move(point));
    }
    points.push_back(std::move(diagonal));
  }
  return points;
}

// Between two points, in shares of the ranges, along the parameter in which they differ most.
double apart(const VectorXd& one, const VectorXd& other, const FitBounds& bounds) {
  return ((one - other).array() / (bounds.to - bounds.from).array()).abs().maxCoeff();
}

// The best of the points, and the next best that are far from those before.
std::vector<VectorXd> best_starts(FitRuns& runs, std::vector<VectorXd> points,
                                  const FitBounds& bounds) {
  constexpr std::size_t most = 3;
  constexpr double far = 0.2;
  std::vector<std::pair<double, std::size_t>> order;
  const std::vector<Outcome> outcomes = runs.run(points);
  for (std::size_t k = 0; k < points.size(); ++k)
    order.emplace_back(runs.residuals_of(outcomes[k]).squaredNorm(), k);
  std::ranges::sort(order);
  std::vector<VectorXd> starts;
  for (const auto& entry : order) {
    const std::size_t k = entry.second;
    const bool is_far = std::ranges::all_of(
        starts, [&](const VectorXd& one) { return apart(one, points[k], bounds) > far; });
    if (starts.size() < most && is_far) starts.push_back(points[k]);
  }
  return starts;
}

// The other ends that fit about as well, each once.
std::vector<FitValley> valleys_of(const FitRuns& runs, const std::vector<LeastSquares>& ends,
                                  const LeastSquares& best, const FitBounds& bounds) {
  constexpr double distinct = 0.05, about = 9.0;
  std::vector<FitValley> valleys;
  std::vector<VectorXd> known{best.point};
  for (const LeastSquares& one : ends) {
    const bool is_new = std::ranges::all_of(
        known, [&](const VectorXd& point) { return apart(point, one.point, bounds) > distinct; });
    if (!is_new || one.chi_squared() > best.chi_squared() + about) continue;
    known.push_back(one.point);
    valleys.push_back({runs.settings_at(one.point), one.chi_squared()});
  }
  return valleys;
}

std::vector<FittedParameter> parameters_of(const FitOptions& options, const LeastSquares& solved,
                                           const Settings& settings) {
  std::vector<FittedParameter> all;
  for (std::size_t k = 0; k < options.parameters.size(); ++k) {
    const Parameter& parameter = options.parameters[k];
    const auto at = static_cast<Index>(k);
    const double factor = parameter.range->factor;
    FittedParameter& one = all.emplace_back();
    one.key = parameter.key;
    one.unit = parameter.unit;
    one.text = settings.at(parameter.key);
    one.value = solved.point[at] * factor;
    if (solved.uncertainty[k]) one.uncertainty = *solved.uncertainty[k] * factor;
    one.at_bound = solved.at_bound[k];
    one.reacts = solved.jacobian.col(at).norm() > 0.0;
  }
  return all;
}

std::vector<FittedMeasurement> residuals_of(const FitOptions& options, const FitRuns& runs,
                                            const LeastSquares& solved, const Outcome& best) {
  std::vector<FittedMeasurement> all;
  Index at = 0;
  for (std::size_t k = 0; k < options.measurements.size(); ++k) {
    const Measurement& measured = options.measurements[k];
    FittedMeasurement& one = all.emplace_back();
    one.row = measured.row;
    one.measured = measured.value;
    one.got = value_of(best, measured.row);
    one.sigma = runs.sigmas()[k];
    if (const auto some = measured.residuals(best, one.sigma))
      one.residual = some->size() == 1 ? (*some)[0] : some->norm();
    for (Index column = 0; column < solved.jacobian.cols(); ++column)
      one.reacts.push_back(solved.jacobian.col(column).segment(at, measured.size()).norm() > 0.0);
    at += measured.size();
  }
  return all;
}

}  // namespace

FitResult fit(CaseRunner& runner, const FitOptions& options) {
  const FitBounds bounds = bounds_of(options);
  FitRuns runs(runner, options);
  const VectorXd start = start_of(options, bounds);
  const Outcome first = finished(runs.run({start}).front());
  runs.set_sigmas(numerics_of(first).spacing);
  std::vector<VectorXd> points = scan_of(options, bounds, start);
  points.insert(points.begin(), start);
  const auto residuals = [&](const std::vector<VectorXd>& at) {
    std::vector<VectorXd> all;
    for (const Outcome& outcome : runs.run(at)) all.push_back(runs.residuals_of(outcome));
    return all;
  };
  std::vector<LeastSquares> ends;
  for (const VectorXd& from : best_starts(runs, std::move(points), bounds))
    ends.push_back(least_squares(residuals, bounds, from,
                                 {.difference = options.difference, .rounds = options.rounds}));
  const LeastSquares& solved = *std::ranges::min_element(ends, {}, &LeastSquares::chi_squared);
  FitResult result;
  result.valleys = valleys_of(runs, ends, solved, bounds);
  result.best = finished(runs.run({solved.point}).front());
  if (!runs.finds_all(result.best))
    throw Error(ErrorKind::run_failed, "no run found all that was measured",
                "widen the ranges of --vary, or begin where it is found, with --start");
  result.parameters = parameters_of(options, solved, result.best.setting.settings);
  result.residuals = residuals_of(options, runs, solved, result.best);
  result.chi_squared = solved.chi_squared();
  result.degrees_of_freedom = static_cast<int>(solved.residuals.size() - solved.point.size());
  result.rounds = solved.rounds;
  result.converged = solved.converged;
  result.runs = runner.runs();
  return result;
}

}  // namespace hackle
