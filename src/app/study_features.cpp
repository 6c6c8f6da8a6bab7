// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "app/voice.hpp"
#include "base/child_process.hpp"
#include "base/files.hpp"
#include "study/features.hpp"
#include "study/study_files.hpp"

namespace hackle {
namespace {

struct FeaturesRequest {
  StudyWords words;
  std::vector<std::string> names;
  FeatureOptions options;
};

std::string list_of_features() {
  std::string list;
  for (const FeatureRow& row : feature_rows())
    list += fmt::format("  {:<18} {}\n", row.name, row.sentence);
  return list;
}

void describe_features_kind(CLI::App& kind, FeaturesRequest& request) {
  kind.add_option("SCRIPT", request.words.script, "A script to measure (a plate of its own)");
  describe_study_options(kind, request.words, "out/study/features, or of the script");
  describe_set(kind, request.words);
  kind.add_option("--feature", request.names, "Features of the plate by name (all)")
      ->type_name("NAME,...")
      ->delimiter(',');
  kind.add_flag("--instructions", request.options.count,
                "Also count instructions per node-step, with valgrind; not of a script");
  kind.add_option("--rounds", request.options.rounds,
                  "Runs of each kind; the least time counts (3)")
      ->type_name("N")
      ->check(CLI::Range(1, 100));
  kind.footer(
      "Without a script: a cracked plate with one feature at a time, on one thread. Time per\n"
      "node-step is the difference of runs of 550 and 50 steps, so that start-up cancels; start "
      "is\n"
      "a run of no step; MB more is the largest memory less that of the plate without features.\n"
      "What is absent must have the numbers of the first row. With a script: as written, without\n"
      "pictures and movies, and what the run tells of its parts (of wall time). Features:\n" +
      list_of_features());
}

CaseRunner runner_of_plate(const StudyWords& words) {
  const StudyScript script{.program = this_program(),
                           .path = data_file("scripts/study/feature.lua")};
  const auto folder =
      words.folder.empty() ? std::filesystem::path("out/study/features") : words.folder;
  RunnerOptions options = runner_options_of(words, folder);
  options.threads = 1;
  return {script, options};
}

void study_features(const FeaturesRequest& request, const std::vector<std::string>& arguments) {
  const bool of_script = !request.words.script.empty();
  FeatureOptions options = request.options;
  options.count = options.count && this_launcher().rank == 0;  // whose counts are reported
  CaseRunner runner =
      of_script ? runner_of(request.words, arguments) : runner_of_plate(request.words);
  const auto costs = of_script ? measure_script(runner, options)
                               : measure_features(runner, features_named(request.names), options);
  finish({"features", text_of(costs), table_of(costs), {}}, to_json(costs), request.words, runner);
}

}  // namespace

void describe_study_features(CLI::App& study, StudyAction& action) {
  describe_kind<FeaturesRequest>(study, action, "features",
                                 "What each feature of a scene adds in time and memory",
                                 describe_features_kind, study_features);
}

}  // namespace hackle
