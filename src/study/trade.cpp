// SPDX-License-Identifier: MIT
#include "study/trade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "study/front.hpp"
#include "study/moments.hpp"
#include "study/scene_numerics.hpp"
#include "study/trade_axes.hpp"

namespace hackle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double one_percent = 0.01;
// What a quantity adds to the score at most, in sizes that count as one: also if it is not found.
constexpr double worst = 10.0;
// The reference may cost as much as this many runs of the script as written, or this many seconds.
constexpr double most_of_reference = 40.0, least_budget = 60.0;
constexpr std::size_t most_pairs = 16;

double allowed_of(const QuantityRow& row, const SceneNumerics& scene, const QuantityValue& value) {
  if (row.kind == QuantityKind::place || row.kind == QuantityKind::paths) return scene.horizon;
  if (row.kind == QuantityKind::field || row.is_error) return one_percent;
  if (row.kind == QuantityKind::count) return 1.0;
  if (row.name == "crack.length") return scene.horizon;
  if (row.unit == "s") return one_percent * scene.duration;
  if (row.unit == "rad") return std::numbers::pi / 36.0;
  constexpr double share = 0.05;
  const double size = share * std::abs(value.number.value_or(0.0));
  return size > 0.0 ? size : 1.0;
}

class TradeStudy {
 public:
  TradeStudy(CaseRunner& runner, std::vector<QuantityRow> quantities) : runner_(&runner) {
    trade_.quantities = std::move(quantities);
    if (trade_.quantities.empty())
      trade_.quantities.assign(quantity_rows().begin(), quantity_rows().end());
  }

  Trade made() {
    begin();
    vary_one_at_a_time();
    combine();
    choose();
    return std::move(trade_);
  }

 private:
  Case case_of(Settings settings) const { return {std::move(settings), sample_at_, false}; }

  // The script as written says when to compare, and what a run costs.
  void begin() {
    const Outcome first = finished(runner_->run_alone({}, "as written"));
    scene_ = numerics_of(first);
    sample_at_ = moment_of_comparison(first);
    usual_cost_ = first.cpu;
  }

  // The reference runs beside all that varies one choice: it takes longest, and begins first.
  void vary_one_at_a_time() {
    axes_ = trade_axes(scene_);
    const auto references =
        reference_settings(scene_, std::max(most_of_reference, least_budget / usual_cost_));
    std::vector<Case> cases{case_of(references[0]), case_of({}), case_of(last_bits(scene_.E))};
    for (const TradeAxis& axis : axes_)
      for (const Settings& settings : axis.values) cases.push_back(case_of(settings));
    std::vector<Outcome> outcomes = runner_->run(cases, "one choice at a time");
    for (std::size_t k = 1; k < references.size() && !outcomes[0].finished(); ++k)
      outcomes[0] = runner_->run_alone(case_of(references[k]), "reference");
    take_reference(finished(outcomes[0]));
    trade_.noise = errors_of(finished(outcomes[2]), finished(outcomes[1]));
    outcomes.erase(outcomes.begin() + 2);
    outcomes.erase(outcomes.begin());
    for (const Outcome& outcome : outcomes) add(outcome);
    mark_front();
  }

  void take_reference(const Outcome& outcome) {
    trade_.reference.outcome = outcome;
    for (const QuantityRow& row : trade_.quantities)
      trade_.allowed[std::string(row.name)] = allowed_of(row, scene_, value_of(outcome, row));
    trade_.reference.errors = errors_of(outcome, outcome);
    trade_.reference.error = 0.0;
  }

  std::map<std::string, std::optional<double>> errors_of(const Outcome& outcome,
                                                         const Outcome& reference) const {
    std::map<std::string, std::optional<double>> errors;
    for (const QuantityRow& row : trade_.quantities) {
      const QuantityValue value = value_of(outcome, row), right = value_of(reference, row);
      if (value.found() || right.found())
        errors[std::string(row.name)] = error_of(value, right, row);
    }
    return errors;
  }

  // The root mean square of the errors over the sizes that count as one.
  double score(const std::map<std::string, std::optional<double>>& errors) const {
    double sum = 0.0;
    for (const auto& [name, error] : errors) {
      const double share = error ? std::min(*error / trade_.allowed.at(name), worst) : worst;
      sum += share * share;
    }
    return errors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors.size()));
  }

  void add(const Outcome& outcome) {
    TradeRun run{.outcome = outcome, .error = infinity};
    if (outcome.finished()) {
      run.errors = errors_of(outcome, trade_.reference.outcome);
      run.error = score(run.errors);
    }
    tried_.insert(outcome.setting.settings);
    trade_.runs.push_back(std::move(run));
  }

  // Runs that change the model are none that one can choose.
  void mark_front() {
    std::vector<Candidate> all;
    for (const TradeRun& run : trade_.runs)
      all.push_back({run.outcome.cpu, is_of_model(run) ? infinity : run.error});
    const std::vector<bool> front = front_of(all);
    for (std::size_t k = 0; k < front.size(); ++k) trade_.runs[k].on_front = front[k];
  }

  bool is_of_model(const TradeRun& run) const {
    return std::ranges::any_of(axes_, [&](const TradeAxis& axis) {
      return axis.of_model &&
             std::ranges::find(axis.values, run.outcome.setting.settings) != axis.values.end();
    });
  }

  // Returns the number of the axis of a run that varies one choice.
  std::size_t axis_of(const Settings& settings) const {
    const auto axis = std::ranges::find_if(axes_, [&](const TradeAxis& one) {
      return std::ranges::find(one.values, settings) != one.values.end();
    });
    return static_cast<std::size_t>(axis - axes_.begin());
  }

  void want(const Settings& settings, std::vector<Case>& cases) {
    if (tried_.insert(settings).second) cases.push_back(case_of(settings));
  }

  // What is fast by its arithmetic on every lattice that is on the front, and pairs of the front.
  void combine() {
    std::vector<Case> cases;
    const Settings fast = fast_arithmetic();
    std::vector<Settings> best;
    for (const TradeRun& run : trade_.runs)
      if (run.on_front && !run.outcome.setting.settings.empty())
        best.push_back(run.outcome.setting.settings);
    want(fast, cases);
    for (const TradeAxis& axis : axes_)
      if (axis.of_lattice)
        for (const Settings& lattice : axis.values) want(joined(lattice, fast), cases);
    std::size_t pairs = 0;
    for (const Settings& one : best)
      for (const Settings& other : best)
        if (may_join(one, other) && pairs < most_pairs && !tried_.contains(joined(one, other))) {
          ++pairs;
          want(joined(one, other), cases);
          want(joined(fast, joined(one, other)), cases);
        }
    for (const Outcome& outcome : runner_->run(cases, "combinations", slowest())) add(outcome);
    mark_front();
  }

  // A run that takes longer than the reference is beaten by it.
  double slowest() const { return 2.0 * trade_.reference.outcome.wall; }

  bool may_join(const Settings& one, const Settings& other) const {
    const std::size_t a = axis_of(one), b = axis_of(other);
    if (a >= b || b >= axes_.size()) return false;
    return !(axes_[a].of_lattice && axes_[b].of_lattice);
  }

  // The cheapest value of each axis that only changes the arithmetic, if it saves anything.
  Settings fast_arithmetic() const {
    Settings fast;
    for (const TradeAxis& axis : axes_) {
      if (!axis.exact_by_itself) continue;
      const TradeRun* cheapest = &trade_.runs.front();
      for (const TradeRun& run : trade_.runs) {
        const bool of_axis =
            std::ranges::find(axis.values, run.outcome.setting.settings) != axis.values.end();
        const bool harmless = run.error < 2.0 * trade_.runs.front().error + one_percent;
        if (of_axis && harmless && run.outcome.cpu < cheapest->outcome.cpu) cheapest = &run;
      }
      fast = joined(fast, cheapest->outcome.setting.settings);
    }
    return fast;
  }

  void choose() {
    for (const double share : {0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
      const double budget = share * trade_.runs.front().outcome.cpu;
      std::optional<std::size_t> best;
      for (std::size_t k = 0; k < trade_.runs.size(); ++k) {
        const TradeRun& run = trade_.runs[k];
        if (run.on_front && run.outcome.cpu <= budget &&
            (!best || run.error < trade_.runs[*best].error))
          best = k;
      }
      if (best) trade_.recommended.push_back({budget, *best});
    }
  }

  CaseRunner* runner_;
  Trade trade_;
  SceneNumerics scene_;
  double sample_at_ = 0.0, usual_cost_ = 0.0;
  std::vector<TradeAxis> axes_;
  std::set<Settings> tried_;
};

}  // namespace

Trade trade(CaseRunner& runner, std::vector<QuantityRow> quantities) {
  return TradeStudy(runner, std::move(quantities)).made();
}

}  // namespace hackle
