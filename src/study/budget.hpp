// SPDX-License-Identifier: MIT
// An error budget: the cheapest numerics expected to keep the paths of cracks within a distance of
// those that half the spacing gives, from a stored calibration and from coarse trial runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/report/error_budget.hpp"
#include "study/case_runner.hpp"

namespace hackle {

struct BudgetOptions {
  double within = 0.0;            // m
  bool verify = false;            // measures the error too
  std::optional<double> horizon;  // m, given by the script: spacings divide it; none: four spacings
  std::optional<double> max_spacing;  // m, given by the script
  std::string precision;              // given by the script; "": f32
  double side = 0.0;                  // m, the shorter one of the plate
};

// How errors, distances to the paths of half the spacing, go with what trials tell. Shares that
// nine of ten ready scenes keep; how they were measured is told in the file.
struct BudgetCalibration {
  double of_same = 0.0;     // error of the finer of two trials over their distance
  double of_coarser = 0.0;  // likewise of the coarser one
  // In horizons: no error is expected to be smaller. That two trials agree more closely is luck,
  // which the next spacing need not have.
  double least = 0.0;
  struct Level {
    double m = 0.0;
    double error = 0.0;  // in horizons
  };
  std::vector<Level> levels;  // for a choice without trials, from the coarsest on
};

// Reads assets/error_budget.json. Throws Error (files).
BudgetCalibration budget_calibration();

// Returns the spacings that are tried, m, from the coarsest on. Each is two thirds or three
// quarters of the one before, and half of the one before that.
std::vector<double> budget_spacings(const BudgetOptions& options);

// Returns the choice for a scene that cannot be tried.
ErrorBudget budget_from(const BudgetCalibration& calibration, const BudgetOptions& options);

// Runs the script with ever finer spacings until the error of one is expected to be small enough,
// or as small as can be expected where the horizon is given and `within` is less than that,
// and once more with another fifth digit of the stiffness, to see whether it is chaotic. A script
// that runs several simulations is judged by the last. Throws what CaseRunner throws, and Error
// (run_failed) if no trial finishes.
ErrorBudget budget_by_trials(CaseRunner& runner, const BudgetCalibration& calibration,
                             const BudgetOptions& options);

}  // namespace hackle
