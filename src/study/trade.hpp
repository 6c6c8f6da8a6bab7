// SPDX-License-Identifier: MIT
// What a scene loses when it is solved faster, and what it costs to be surer: many ways to solve it
// against a reference that is finer in every respect.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/case_runner.hpp"
#include "study/quantity.hpp"

namespace hackle {

struct TradeRun {
  Outcome outcome;
  std::map<std::string, std::optional<double>>
      errors;          // by quantity, in its unit, of the reference
  double error = 0.0;  // all of them in one number, see score(); infinite if it did not finish
  bool on_front = false;
};

// The best of the front that costs at most the budget.
struct Recommendation {
  double budget = 0.0;  // s of CPU time
  std::size_t run = 0;  // in Trade::runs
};

struct Trade {
  std::vector<QuantityRow> quantities;
  std::map<std::string, double> allowed;  // the size of an error that counts as one, by quantity
  TradeRun reference;
  std::vector<TradeRun> runs;  // the first is the script as written
  // How far a change in the last bits of the stiffness moves the script as written: what is smaller
  // than this is not an error of the numerics.
  std::map<std::string, std::optional<double>> noise;
  std::vector<Recommendation> recommended;
};

// Runs the script over precision, spacing, m, quadrature, surface correction, constants, step,
// fidelity, fused arithmetic, history and outputs, one at a time, then what is fast together. With
// no quantities, all are compared. Throws what CaseRunner throws, and Error (run_failed) if the
// script as written or the reference fails.
Trade trade(CaseRunner& runner, std::vector<QuantityRow> quantities);

}  // namespace hackle
