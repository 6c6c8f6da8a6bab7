// SPDX-License-Identifier: MIT
#include "app/study_kinds.hpp"

namespace hackle {

void describe_study(CLI::App& app, StudyAction& action) {
  CLI::App* study = app.add_subcommand("study", "Run a script many times and compare");
  study->require_subcommand(1);
  describe_study_trade(*study, action);
  describe_study_ensemble(*study, action);
  describe_study_envelope(*study, action);
  describe_study_features(*study, action);
  describe_study_convergence(*study, action);
  describe_study_sweep(*study, action);
  describe_study_fit(*study, action);
}

}  // namespace hackle
