// SPDX-License-Identifier: MIT
// A script run with all combinations of values of its settings, and the value at which a condition
// begins to hold.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/case_runner.hpp"
#include "study/condition.hpp"
#include "study/parameter.hpp"
#include "study/quantity.hpp"

namespace hackle {

struct SweepOptions {
  std::vector<Parameter> parameters;    // with different keys
  std::vector<QuantityRow> quantities;  // of tables; empty: see Sweep
  bool with_pictures = false;           // of the last state of every run
  std::optional<Condition> threshold;   // asks for one parameter with a range, and no other list
  std::optional<double> tolerance;      // of the threshold, SI; default: 1/64 of the range
};

struct SweepRun {
  Outcome outcome;
  std::vector<std::optional<double>> numbers;  // of the parameters, SI, if they are numbers
};

// Where a condition changes.
struct Threshold {
  Condition condition;
  std::string key;
  std::string unit;  // of the numbers, SI
  // The nearest values, SI, at which it holds and does not; nothing where it is never so.
  std::optional<double> holds_at, fails_at;
  // It changed more than once along the values that were looked at; the bracket is then that of the
  // first change.
  bool several = false;

  bool found() const { return holds_at && fails_at; }
};

struct Sweep {
  std::vector<Parameter> parameters;    // those that vary
  std::vector<QuantityRow> quantities;  // as asked for, or all that are not fields
  std::vector<SweepRun> runs;           // in the order of the combinations, or of the parameter
  std::optional<Threshold> threshold;
  int runs_made = 0;  // that were not kept from earlier
};

// Runs all. If the first and the last run fail, throws Error (run_failed) with the reason of the
// first before it starts the others; single failures stay among the runs. With a threshold, runs
// the values of the range (its ends, where it has no step), then bisects the first interval along
// which the condition changes: the result does not depend on the number of threads. Throws what
// CaseRunner throws, and Error (usage) if a threshold is asked of more than one parameter.
Sweep sweep(CaseRunner& runner, const SweepOptions& options);

}  // namespace hackle
