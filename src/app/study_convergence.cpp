// SPDX-License-Identifier: MIT

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "study/convergence_files.hpp"

namespace hackle {
namespace {

struct ConvergenceRequest {
  StudyWords words;
  std::vector<std::string> names;  // of quantities
  std::vector<std::string> axes;
  ConvergenceOptions options;
};

void describe_words(CLI::App& kind, ConvergenceRequest& request) {
  describe_study_words(kind, request.words);
  describe_set(kind, request.words);
  describe_quantities(kind, request.names);
  const auto& names = enum_names<RefinedBy>;
  kind.add_option("--by", request.axes, "What is refined: delta, m, step (all three)")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
  kind.add_option("--levels", request.options.levels,
                  "Number of levels of delta and step, one of delta coarser than the script (3)")
      ->type_name("N")
      ->check(CLI::Range(2, 8));
  kind.add_option("--ratio", request.options.ratio,
                  "Ratio of the spacings of two levels of delta (2)")
      ->type_name("R")
      ->check(CLI::Range(1.05, 4.0));
  kind.add_option("--budget", request.options.budget,
                  "CPU time that a level may be expected to take, in s; more is left out (600)")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9));
  kind.footer(
      "delta: spacing and horizon together; m: the spacing with the horizon kept, m = 3, 4, 6, 8;\n"
      "step: the time step. Where the script has options spacing and horizon, they follow.\n"
      "order: p of f + C h^p, from the three finest levels; limit: f after Richardson; GCI: the\n"
      "error of the finest level with a factor of safety, 1.25 (3 for two levels), of numbers as "
      "a\n"
      "share.");
}

void carry_out_convergence(const ConvergenceRequest& asked,
                           const std::vector<std::string>& arguments) {
  ConvergenceRequest request = asked;
  request.options.quantities = quantities_named(request.names);
  if (!request.axes.empty()) request.options.axes.clear();
  for (const std::string& name : request.axes)
    request.options.axes.push_back(*value_named<RefinedBy>(name));
  CaseRunner runner = runner_of(request.words, arguments);
  request.options.declared = declared_options(request.words, arguments);
  const ConvergenceStudy study = convergence(runner, request.options);
  finish(findings_of(study), to_json(study), request.words, runner);
}

}  // namespace

void describe_study_convergence(CLI::App& study, StudyAction& action) {
  describe_kind<ConvergenceRequest>(
      study, action, "convergence",
      "Refine horizon, spacing and step, and say what converges, how fast, and what does not",
      describe_words, carry_out_convergence);
}

}  // namespace hackle
