// SPDX-License-Identifier: MIT
// Settings of a script that make its results agree best with what was measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/case_runner.hpp"
#include "study/measurement.hpp"
#include "study/parameter.hpp"

namespace hackle {

struct FitOptions {
  std::vector<Parameter> parameters;         // with ranges; at least one
  std::vector<Measurement> measurements;     // at least one
  std::vector<std::optional<double>> start;  // of the parameters, SI; default: the middle
  double difference = 1.0 / 32.0;  // for derivatives, as a share of a range: larger than the steps
                                   // that results make, smaller than what they bend over
  int rounds = 12;
};

struct FittedParameter {
  std::string key, unit;
  double value = 0.0;                 // SI
  std::string text;                   // for --set
  std::optional<double> uncertainty;  // one standard deviation, SI
  bool at_bound = false;
  bool reacts = true;  // some residual depends on it
};

struct FittedMeasurement {
  QuantityRow row;
  QuantityValue measured, got;
  double sigma = 0.0;              // in the unit of the row
  std::optional<double> residual;  // over sigma; of a path the root mean square; signed for numbers
  std::vector<bool> reacts;        // to the parameters
};

// Another end of the search, from another start.
struct FitValley {
  Settings settings;  // of the parameters
  double chi_squared = 0.0;
};

struct FitResult {
  std::vector<FittedParameter> parameters;
  std::vector<FittedMeasurement> residuals;
  Outcome best;
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  int rounds = 0;
  int runs = 0;  // that were not kept from earlier
  bool converged = false;
  std::vector<FitValley> valleys;  // that fit about as well: within 9 of chi^2
};

// A measurement that has no sigma has 1 % of a number, 1 for a count, the spacing for a place or a
// path. What a run does not find has residuals of 100 sigma. Begins at the best of the start and of
// four values of each parameter without one, and at up to two more of these far from it; the best
// end counts, and the others are told where they fit about as well. Throws what CaseRunner throws,
// and Error (run_failed) if no run finds all that was measured.
FitResult fit(CaseRunner& runner, const FitOptions& options);

}  // namespace hackle
