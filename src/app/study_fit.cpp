// SPDX-License-Identifier: MIT

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "base/error.hpp"
#include "study/fit_report.hpp"

namespace hackle {
namespace {

struct FitRequest {
  StudyWords words;
  std::vector<std::string> ranges, targets, sigmas, starts;
  double difference = 1.0 / 32.0;
  int rounds = 12;
};

void describe_list(CLI::App& kind, const std::string& name, std::vector<std::string>& words,
                   const std::string& sentence, const std::string& type) {
  kind.add_option(name, words, sentence)->type_name(type)->take_all()->allow_extra_args(false);
}

void describe_fit_words(CLI::App& kind, FitRequest& request) {
  describe_study_words(kind, request.words);
  describe_set(kind, request.words);
  describe_list(kind, "--vary", request.ranges,
                "A setting to find and its bounds, as in material.G0=100:400J/m2; repeatable",
                "key=FROM:TO");
  describe_list(kind, "--to", request.targets,
                "What was measured: fork.time=22us, fork.place=67mm,20mm, or tip.path=FILE.csv "
                "with columns x and y; repeatable",
                "NAME=VALUE");
  describe_list(kind, "--sigma", request.sigmas,
                "Its standard deviation, as in fork.time=0.5us (1 % of a number, a spacing of a "
                "place or path); repeatable",
                "NAME=VALUE");
  describe_list(kind, "--start", request.starts,
                "Where to begin, as in load=10MPa (the best of five values); repeatable",
                "key=VALUE");
  kind.add_option("--difference", request.difference,
                  "Differences for derivatives, as a share of the bounds (0.03)")
      ->type_name("SHARE")
      ->check(CLI::Range(1e-4, 0.5));
  kind.add_option("--rounds", request.rounds, "At most so many rounds (12)")
      ->type_name("N")
      ->check(CLI::Range(1, 100));
  kind.footer(
      "Levenberg-Marquardt with central differences: results are the same bits every time, so "
      "that\n"
      "differences are clean. Each round takes three runs and two or more for every --vary.");
}

void set_start(FitOptions& options, const std::string& word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const auto found = std::ranges::find(options.parameters, word.substr(0, equals), &Parameter::key);
  const auto value = measure_of(word.substr(std::min(equals + 1, word.size())));
  if (found == options.parameters.end() || !value)
    throw Error(ErrorKind::usage,
                fmt::format("--start {}: not key=VALUE of something that --vary names", word),
                "as in --start load=10MPa");
  options.start[static_cast<std::size_t>(found - options.parameters.begin())] = value->value();
}

FitOptions fit_options_of(const FitRequest& request) {
  FitOptions options;
  Problems problems;
  if (request.ranges.empty())
    problems.add("nothing varies", "as in --vary material.G0=100:400J/m2");
  if (request.targets.empty()) problems.add("nothing was measured", "as in --to fork.time=22us");
  problems.throw_if_any(ErrorKind::usage);
  for (const std::string& word : request.ranges)
    options.parameters.push_back(ranged_parameter_of(word));
  for (const std::string& word : request.targets)
    options.measurements.push_back(measurement_of(word));
  for (const std::string& word : request.sigmas) set_sigma(options.measurements, word);
  options.start.resize(options.parameters.size());
  for (const std::string& word : request.starts) set_start(options, word);
  options.difference = request.difference;
  options.rounds = request.rounds;
  return options;
}

void carry_out_fit(const FitRequest& request, const std::vector<std::string>& arguments) {
  const FitOptions options = fit_options_of(request);
  CaseRunner runner = runner_of(request.words, arguments);
  const FitResult result = fit(runner, options);
  finish(findings_of(result), to_json(result), request.words, runner);
}

}  // namespace

void describe_study_fit(CLI::App& study, StudyAction& action) {
  describe_kind<FitRequest>(study, action, "fit",
                            "Find settings of a script that agree best with what was measured",
                            describe_fit_words, carry_out_fit);
}

}  // namespace hackle
