// SPDX-License-Identifier: MIT
// What simulate(p, { within = ... }) has chosen, for the report of a run.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace hackle {

struct ErrorBudget {
  double within = 0.0;   // m, how far the paths of cracks may be from those of half the spacing
  double spacing = 0.0;  // m, chosen
  std::string precision = "f32";   // chosen, unless the script says it
  std::optional<double> expected;  // m; none: cracks are chaotic, or none grew
  std::optional<double> measured;  // m, from half the spacing in f64; if it was to be verified
  int trials = 0;                  // runs of the script; 0: by the calibration alone
  double trial_cpu = 0.0;          // s, of the trials
  bool chaotic = false;    // a change of the stiffness by 1e-5 moves paths farther than that
  bool uncracked = false;  // no crack grew in any trial

  bool is_met() const { return expected && *expected <= within; }
};

// Returns "paths within 0.5 mm asked, 0.31 mm expected of a spacing of 0.333 mm in f32 (4 trials,
// 1.2 s)".
std::string describe(const ErrorBudget& budget);

// Returns {"within_m":..,"spacing_m":..,"expected_m":..,"measured_m":..,..}.
nlohmann::ordered_json to_json(const ErrorBudget& budget);

}  // namespace hackle
