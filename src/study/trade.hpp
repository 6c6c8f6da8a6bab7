// SPDX-License-Identifier: MIT
// What a scene loses when it is solved faster, and what it costs to be surer: many ways to solve it
// against a reference that is finer in every respect.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/case_runner.hpp"
#include "study/picture_cost.hpp"
#include "study/trade_run.hpp"

namespace hackle {

// The best of the front that costs at most the budget.
struct Recommendation {
  double budget = 0.0;  // s of CPU time
  std::size_t run = 0;  // in Trade::runs
};

struct Trade {
  std::vector<QuantityRow> quantities;
  std::map<std::string, double> allowed;  // see allowed_error(), by quantity
  TradeRun reference;
  std::vector<TradeRun> runs;  // the first is the script as written
  // How far a change in the last bits of the stiffness moves the script as written: what is smaller
  // than this is no error of the numerics.
  Errors noise;
  std::vector<Recommendation> recommended;
  // Of a scene that takes long: the ways were chosen on a lattice coarser by this; else 1.
  double screened_at = 1.0;
  std::size_t skipped = 0;            // combinations that could not be on the front
  std::vector<PictureCost> pictures;  // on the lattice of the screening; empty if it makes no movie
};

struct TradeOptions {
  // s of CPU time: a scene that takes longer is screened first, on a lattice on which it takes
  // about `screening`.
  double costly = 2.0;
  double screening = 0.5;
  bool pictures = true;  // tries cadences and sizes of movies too
};

// Runs the script over precision, spacing, m, horizon, quadrature, surface correction, constants,
// step, fidelity, fused arithmetic and history, one at a time, then what is fast together; and over
// cadence and size of its movies. Of a costly scene all of this is done on a coarser lattice, and
// only what is best there with the spacing of the script. With no quantities, all are compared.
// Throws what CaseRunner throws, and Error (run_failed) if the script as written or the reference
// fails.
Trade trade(CaseRunner& runner, std::vector<QuantityRow> quantities,
            const TradeOptions& options = {});

}  // namespace hackle
