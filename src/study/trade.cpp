// SPDX-License-Identifier: MIT
#include "study/trade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "study/front.hpp"
#include "study/moments.hpp"
#include "study/trade_axes.hpp"
#include "study/trade_forecast.hpp"

namespace hackle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_pairs = 16, most_of_screen = 8;
// Runs that take less, s, are timed again, this often.
constexpr double short_run = 1.0;
constexpr int timings = 2;
// Budgets, in costs of the scene as written. Beyond the largest nothing is recommended.
constexpr std::array budgets{0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
// Of a reference: costs of the scene as written, and s, whatever is less; but at least so many
// costs.
constexpr double most_of_reference = 40.0, seconds_of_reference = 40.0, least_of_reference = 3.0;

// The scene whose solutions are compared.
struct Subject {
  Settings base;  // of all runs
  SceneNumerics scene;
  double sample_at = 0.0;      // s
  double cost = 0.0;           // s of CPU time, as written
  double most = 0.0;           // costs of the reference, in these
  std::vector<Settings> ways;  // if not empty, only these are tried
};

class TradeStudy {
 public:
  TradeStudy(CaseRunner& runner, const std::vector<QuantityRow>& quantities, Subject subject)
      : runner_(&runner), subject_(std::move(subject)) {
    trade_.quantities = quantities;
  }

  Trade made() {
    vary_one_at_a_time();
    if (subject_.ways.empty()) combine();
    time_again();
    choose();
    return std::move(trade_);
  }

 private:
  Case case_of(const Settings& settings, int repeat = 0) const {
    return {joined(subject_.base, settings), subject_.sample_at, false, repeat};
  }
  std::vector<Outcome> outcomes_of(const std::vector<Settings>& all, const std::string& what,
                                   double time_limit, int repeat = 0) {
    std::vector<Case> cases;
    cases.reserve(all.size());
    for (const Settings& settings : all) cases.push_back(case_of(settings, repeat));
    return runner_->run(cases, what, time_limit);
  }

  // The reference runs beside all that varies one choice: it takes longest, and begins first.
  void vary_one_at_a_time() {
    if (subject_.ways.empty()) axes_ = trade_axes(subject_.scene);
    const auto references = reference_settings(subject_.scene, subject_.most);
    std::vector<Settings> all{references[0], {}, last_bits(subject_.scene)};
    for (const TradeAxis& axis : axes_)
      all.insert(all.end(), axis.values.begin(), axis.values.end());
    all.insert(all.end(), subject_.ways.begin(), subject_.ways.end());
    constexpr double patience = 4.0;
    const double time_limit = patience * (subject_.most * subject_.cost + 1.0);
    std::vector<Outcome> outcomes = outcomes_of(all, "one choice at a time", time_limit);
    std::size_t used = 0;
    while (!outcomes[0].finished() && ++used < references.size())
      outcomes[0] = runner_->run_alone(case_of(references[used]), "reference");
    take_reference(references[std::min(used, references.size() - 1)], finished(outcomes[0]));
    trade_.noise = errors_of(finished(outcomes[2]), finished(outcomes[1]), trade_.quantities);
    for (std::size_t k = 1; k < all.size(); ++k)
      if (k != 2) add(all[k], outcomes[k]);
    mark_front();
  }

  void take_reference(const Settings& settings, const Outcome& outcome) {
    trade_.reference = {settings, outcome, errors_of(outcome, outcome, trade_.quantities)};
    for (const QuantityRow& row : trade_.quantities)
      trade_.allowed[std::string(row.name)] = allowed_error(row, subject_.scene, outcome);
  }

  void add(const Settings& settings, const Outcome& outcome) {
    TradeRun run{settings, outcome, {}, infinity};
    if (outcome.finished()) {
      run.errors = errors_of(outcome, trade_.reference.outcome, trade_.quantities);
      run.error = score(run.errors, trade_.allowed);
    }
    tried_.insert(settings);
    trade_.runs.push_back(std::move(run));
  }

  // Runs that change the model are none that one can choose.
  Candidate candidate(const TradeRun& run) const {
    return {run.outcome.cpu, is_of_model(run.settings, axes_) ? infinity : run.error};
  }
  void mark_front() {
    std::vector<Candidate> all;
    all.reserve(trade_.runs.size());
    for (const TradeRun& run : trade_.runs) all.push_back(candidate(run));
    const std::vector<bool> front = front_of(all);
    for (std::size_t k = 0; k < front.size(); ++k) trade_.runs[k].on_front = front[k];
  }

  std::optional<std::size_t> axis_of(const Settings& settings) const {
    for (std::size_t k = 0; k < axes_.size(); ++k)
      if (axes_[k].has(settings)) return k;
    return std::nullopt;
  }

  // What is fast by its arithmetic, and what is surest by all else, on every lattice, and pairs of
  // the front.
  void combine() {
    std::vector<Settings> all;
    const double most = budgets.back() * trade_.runs.front().outcome.cpu;
    const auto want = [&](const Settings& settings) {
      if (!tried_.insert(settings).second) return;
      if (is_hopeless(forecast_of(settings, axes_, trade_.runs), axes_, trade_.runs, most))
        ++trade_.skipped;
      else
        all.push_back(settings);
    };
    const Settings fast = fast_arithmetic(axes_, trade_.runs), sure = surest(axes_, trade_.runs);
    want(fast);
    want(joined(fast, sure));
    for (const TradeAxis& axis : axes_)
      if (axis.of_lattice)
        for (const Settings& lattice : axis.values) {
          want(joined(lattice, fast));
          want(joined(joined(lattice, fast), sure));
        }
    std::size_t pairs = 0;
    for (const TradeRun& one : trade_.runs)
      for (const TradeRun& other : trade_.runs) {
        if (!one.on_front || !other.on_front || !may_join(one.settings, other.settings)) continue;
        if (pairs++ >= most_pairs) continue;
        want(joined(one.settings, other.settings));
        want(joined(fast, joined(one.settings, other.settings)));
      }
    const std::vector<Outcome> outcomes = outcomes_of(all, "combinations", patience());
    for (std::size_t k = 0; k < all.size(); ++k) add(all[k], outcomes[k]);
    mark_front();
  }

  // What takes longer than the reference, or than any budget, cannot be recommended.
  double patience() const {
    constexpr double margin = 1.5, start = 1.0;  // of a busy machine, s
    const double of_budget = budgets.back() * trade_.runs.front().outcome.cpu;
    return margin * std::min(trade_.reference.outcome.wall, of_budget) + start;
  }

  bool may_join(const Settings& one, const Settings& other) const {
    const auto a = axis_of(one), b = axis_of(other);
    if (!a || !b || *a >= *b) return false;
    return !(axes_[*a].of_lattice && axes_[*b].of_lattice);
  }

  // What else the machine does only adds to a time: runs near the front are timed again, and the
  // least counts.
  void time_again() {
    std::vector<std::size_t> near;
    std::vector<Settings> all;
    for (std::size_t k = 0; k < trade_.runs.size(); ++k)
      if (trade_.runs[k].outcome.cpu < short_run && (k == 0 || is_near_front(trade_.runs[k]))) {
        near.push_back(k);
        all.push_back(trade_.runs[k].settings);
      }
    for (int repeat = 1; repeat <= timings; ++repeat) {
      const std::vector<Outcome> outcomes = outcomes_of(all, "timing", infinity, repeat);
      for (std::size_t k = 0; k < near.size(); ++k) {
        Outcome& first = trade_.runs[near[k]].outcome;
        if (!outcomes[k].finished()) continue;
        first.cpu = std::min(first.cpu, outcomes[k].cpu);
        first.wall = std::min(first.wall, outcomes[k].wall);
      }
    }
    mark_front();
  }

  bool is_near_front(const TradeRun& run) const {
    constexpr double clearly_cheaper = 0.75;
    const Candidate mine = candidate(run);
    return std::isfinite(mine.error) &&
           std::ranges::none_of(trade_.runs, [&](const TradeRun& other) {
             const Candidate its = candidate(other);
             return its.cost < clearly_cheaper * mine.cost && its.error <= mine.error;
           });
  }

  void choose() {
    for (const double share : budgets) {
      const double budget = share * trade_.runs.front().outcome.cpu;
      std::optional<std::size_t> best;
      for (std::size_t k = 0; k < trade_.runs.size(); ++k) {
        const TradeRun& run = trade_.runs[k];
        const bool fits = run.on_front && run.outcome.cpu <= budget;
        if (fits && (!best || run.error < trade_.runs[*best].error)) best = k;
      }
      if (best) trade_.recommended.push_back({budget, *best});
    }
  }

  CaseRunner* runner_;
  Subject subject_;
  Trade trade_;
  std::vector<TradeAxis> axes_;
  std::set<Settings> tried_;
};

double most_for_reference(double cost) {
  return std::clamp(seconds_of_reference / cost, least_of_reference, most_of_reference);
}

// The same scene on a lattice so coarse that it takes `cost`, s.
Subject coarsened(const Subject& subject, double cost) {
  const double factor = std::cbrt(subject.cost / cost);
  Subject coarse = subject;
  coarse.scene.spacing *= factor;
  coarse.scene.horizon *= factor;
  coarse.base = spaced(coarse.scene.spacing, coarse.scene.m());
  coarse.cost = cost;
  coarse.most = most_for_reference(cost);
  return coarse;
}

// What is best on the coarse lattice, the surest first, for the lattice as written.
std::vector<Settings> best_of(const Trade& screen, double factor) {
  std::vector<const TradeRun*> front;
  for (const TradeRun& run : screen.runs)
    if (run.on_front && !run.settings.empty()) front.push_back(&run);
  std::ranges::sort(front, {}, [](const TradeRun* run) { return run->error; });
  if (front.size() > most_of_screen) front.resize(most_of_screen);
  std::vector<Settings> ways;
  ways.reserve(front.size());
  for (const TradeRun* run : front) ways.push_back(with_finer_lattice(run->settings, factor));
  return ways;
}

Trade screened(CaseRunner& runner, const std::vector<QuantityRow>& quantities, Subject subject,
               const TradeOptions& options) {
  const Subject coarse = coarsened(subject, options.screening);
  const double factor = coarse.scene.spacing / subject.scene.spacing;
  const Trade screen = TradeStudy(runner, quantities, coarse).made();
  subject.ways = best_of(screen, factor);
  Trade found = TradeStudy(runner, quantities, subject).made();
  found.screened_at = factor;
  found.skipped = screen.skipped;
  if (options.pictures) found.pictures = picture_costs(runner, screen.runs.front().outcome);
  return found;
}

}  // namespace

Trade trade(CaseRunner& runner, std::vector<QuantityRow> quantities, const TradeOptions& options) {
  if (quantities.empty()) quantities.assign(quantity_rows().begin(), quantity_rows().end());
  const Outcome first = finished(runner.run_alone({}, "as written"));
  const Subject subject{.base = {},
                        .scene = numerics_of(first),
                        .sample_at = moment_of_comparison(first),
                        .cost = first.cpu,
                        .most = most_for_reference(first.cpu),
                        .ways = {}};
  if (subject.cost > options.costly) return screened(runner, quantities, subject, options);
  Trade found = TradeStudy(runner, quantities, subject).made();
  if (options.pictures) found.pictures = picture_costs(runner, found.runs.front().outcome);
  return found;
}

}  // namespace hackle
