// SPDX-License-Identifier: MIT
#include "study/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {
namespace {

Case case_of(Settings settings, const SweepOptions& options) {
  return {.settings = std::move(settings), .with_last_picture = options.with_pictures};
}

std::optional<double> number_in(const Parameter& parameter, const std::string& text) {
  const auto found = std::ranges::find(parameter.values, text, &ParameterValue::text);
  return found == parameter.values.end() ? std::nullopt : found->number;
}

// A mistake in a name fails in every run: two that are far apart tell.
void refuse_if_all_fail(CaseRunner& runner, const std::vector<Case>& cases) {
  const Outcome first = runner.run_alone(cases.front(), "the first run");
  if (first.finished()) numerics_of(first);  // a script without a simulation is refused
  if (!first.finished() && !runner.run_alone(cases.back(), "the last run").finished())
    finished(first);
}

std::vector<SweepRun> run_all(CaseRunner& runner, const SweepOptions& options) {
  std::vector<Case> cases;
  for (Settings& settings : combinations(options.parameters))
    cases.push_back(case_of(std::move(settings), options));
  refuse_if_all_fail(runner, cases);
  std::vector<SweepRun> runs;
  for (Outcome& outcome : runner.run(cases, "sweep")) {
    SweepRun& run = runs.emplace_back();
    for (const Parameter& parameter : options.parameters)
      if (parameter.varies())
        run.numbers.push_back(number_in(parameter, outcome.setting.settings.at(parameter.key)));
    run.outcome = std::move(outcome);
  }
  return runs;
}

// Looks for the place where the condition changes; numbers are in the unit of the range.
class Bisection {
 public:
  Bisection(CaseRunner& runner, const SweepOptions& options, const Parameter& parameter)
      : runner_(runner), options_(options), range_(*parameter.range), key_(parameter.key) {
    for (const Parameter& other : options.parameters)
      if (other.key != key_) fixed_[other.key] = other.values.front().text;
  }

  void add(const std::vector<double>& numbers) {
    std::vector<Case> cases;
    for (const double number : numbers) {
      Settings settings = fixed_;
      settings[key_] = range_.text(number);
      cases.push_back(case_of(std::move(settings), options_));
    }
    std::vector<Outcome> outcomes = cases.size() == 1
                                        ? std::vector{runner_.run_alone(cases.front(), "threshold")}
                                        : runner_.run(cases, "threshold");
    for (std::size_t k = 0; k < numbers.size(); ++k)
      looked_at_.push_back(
          {numbers[k], options_.threshold->holds(finished(outcomes[k])), std::move(outcomes[k])});
    std::ranges::sort(looked_at_, {}, &Look::number);
  }

  // Halves the first interval with a change until it is small enough.
  void bisect(double tolerance) {
    for (;;) {
      const auto before = first_change();
      if (before == looked_at_.end()) return;
      const double low = before->number, high = std::next(before)->number;
      if (high - low <= tolerance * (1.0 + 1e-9)) return;
      add({0.5 * (low + high)});
    }
  }

  Threshold result(const Parameter& parameter) {
    Threshold found{*options_.threshold, key_, parameter.unit, {}, {}, changes() > 1};
    const auto before = first_change();
    const auto note = [&](const Look& look) {
      (look.holds ? found.holds_at : found.fails_at) = look.number * range_.factor;
    };
    if (before == looked_at_.end())
      note(looked_at_.front());
    else
      note(*before), note(*std::next(before));
    return found;
  }

  std::vector<SweepRun> runs() {
    std::vector<SweepRun> all;
    for (Look& look : looked_at_)
      all.push_back({std::move(look.outcome), {look.number * range_.factor}});
    return all;
  }

 private:
  struct Look {
    double number = 0.0;
    bool holds = false;
    Outcome outcome;
  };

  static bool differ(const Look& one, const Look& other) { return one.holds != other.holds; }
  std::vector<Look>::iterator first_change() {
    return std::adjacent_find(looked_at_.begin(), looked_at_.end(), differ);
  }
  long changes() const {
    long count = 0;
    for (std::size_t k = 1; k < looked_at_.size(); ++k)
      count += differ(looked_at_[k - 1], looked_at_[k]);
    return count;
  }

  CaseRunner& runner_;
  const SweepOptions& options_;
  ParameterRange range_;
  std::string key_;
  Settings fixed_;
  std::vector<Look> looked_at_;  // by number
};

const Parameter& only_range_of(const SweepOptions& options) {
  const Parameter* found = nullptr;
  for (const Parameter& parameter : options.parameters) {
    if (!parameter.varies()) continue;
    if (found != nullptr || !parameter.range)
      throw Error(ErrorKind::usage,
                  "a threshold is looked for along one range, nothing else varies",
                  "as in --set load=6:24MPa --threshold 'branches >= 2'");
    found = &parameter;
  }
  if (found == nullptr)
    throw Error(ErrorKind::usage, "a threshold needs a range to look for it",
                "as in --set load=6:24MPa");
  return *found;
}

void find_threshold(CaseRunner& runner, const SweepOptions& options, Sweep& result) {
  const Parameter& parameter = only_range_of(options);
  const ParameterRange& range = *parameter.range;
  std::vector<double> numbers;
  for (const ParameterValue& value : parameter.values)
    numbers.push_back(*value.number / range.factor);
  if (numbers.empty()) numbers = {range.from, range.to};
  Bisection bisection(runner, options, parameter);
  bisection.add({numbers.front()});
  if (numbers.size() > 1) bisection.add({numbers.begin() + 1, numbers.end()});
  constexpr double share = 1.0 / 64.0;
  const double finest = 1e-9 * std::max(std::abs(range.from), std::abs(range.to));
  bisection.bisect(options.tolerance ? std::max(*options.tolerance / range.factor, finest)
                                     : share * std::abs(range.to - range.from));
  result.threshold = bisection.result(parameter);
  result.runs = bisection.runs();
}

void check_keys(const std::vector<Parameter>& parameters) {
  std::set<std::string> keys;
  Problems problems;
  for (const Parameter& parameter : parameters)
    if (!keys.insert(parameter.key).second)
      problems.add(fmt::format("--set {} is given twice", parameter.key));
  problems.throw_if_any(ErrorKind::usage);
}

}  // namespace

Sweep sweep(CaseRunner& runner, const SweepOptions& options) {
  check_keys(options.parameters);
  Sweep result;
  for (const Parameter& parameter : options.parameters)
    if (parameter.varies()) result.parameters.push_back(parameter);
  result.quantities = options.quantities;
  if (result.quantities.empty())
    for (const QuantityRow& row : quantity_rows())
      if (row.kind != ComparedAs::field) result.quantities.push_back(row);
  if (options.threshold)
    find_threshold(runner, options, result);
  else
    result.runs = run_all(runner, options);
  result.runs_made = runner.runs();
  return result;
}

}  // namespace hackle
