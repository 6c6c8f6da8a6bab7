// SPDX-License-Identifier: MIT

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/terminal.hpp"
#include "movie/movie_kind.hpp"
#include "study/sweep_files.hpp"
#include "study/sweep_report.hpp"

namespace hackle {
namespace {

struct SweepRequest {
  StudyWords words;
  std::vector<std::string> names;  // of quantities
  std::vector<std::string> ranges;
  std::string threshold, tolerance;
  bool sheet = false;
  std::filesystem::path film;
};

void describe_sweep_words(CLI::App& kind, SweepRequest& request) {
  describe_study_words(kind, request.words);
  describe_quantities(kind, request.names);
  kind.add_option("--set", request.ranges,
                  "What varies or is fixed: an option of the script, simulate.KEY or material.KEY, "
                  "as in load=6:24:2MPa, m=3,4,6 or load=12MPa; repeatable: all combinations")
      ->type_name("key=VALUES")
      ->take_all()
      ->allow_extra_args(false);
  kind.add_option("--threshold", request.threshold,
                  "Find the value of the one range at which a condition begins to hold")
      ->type_name("'NAME >= NUMBER'");
  kind.add_option("--tolerance", request.tolerance,
                  "Of the threshold, as in 0.1MPa (1/64 of the range)")
      ->type_name("VALUE")
      ->needs("--threshold");
  kind.add_flag("--sheet", request.sheet, "Make a contact sheet of the last states, sheet.png");
  kind.add_option("--film", request.film,
                  "Make a film (.mp4, .gif, ...) of the last states, a frame per value")
      ->type_name("FILE");
  kind.footer(
      "FROM:TO:STEP is a range, where the unit of the last holds for all; a list with commas is a\n"
      "list of values, each a run; FROM:TO is one value, a pair, but with --threshold a range. "
      "What\n"
      "contains commas and is one value stands in braces: {1,2}. A condition is NAME <, <=, >, >=\n"
      "or == NUMBER, as in 'branches >= 2' or 'fork.time < 20us'.");
}

SweepOptions sweep_options_of(const SweepRequest& request) {
  SweepOptions options;
  const bool seeks = !request.threshold.empty();
  for (const std::string& word : request.ranges)
    options.parameters.push_back(parameter_of(word, seeks));
  options.quantities = quantities_named(request.names);
  options.with_pictures = request.sheet || !request.film.empty();
  if (seeks) options.threshold = condition_of(request.threshold);
  if (!request.tolerance.empty()) {
    const auto tolerance = measure_of(request.tolerance);
    if (!tolerance || !(tolerance->value() > 0.0))
      throw Error(ErrorKind::usage,
                  fmt::format("--tolerance {}: not a number above 0", request.tolerance),
                  "as in --tolerance 0.1MPa");
    options.tolerance = tolerance->value();
  }
  if (!request.film.empty()) {
    movie_kind(request.film);
    const auto varying = std::ranges::count_if(options.parameters, &Parameter::varies);
    if (varying != 1)
      throw Error(ErrorKind::usage,
                  fmt::format("--film: a film runs over one --set, not {}", varying),
                  "let one --set have several values, or make a sheet");
  }
  return options;
}

void carry_out_sweep(const SweepRequest& request, const std::vector<std::string>& arguments) {
  const SweepOptions options = sweep_options_of(request);
  CaseRunner runner = runner_of(request.words, arguments);
  const Sweep result = sweep(runner, options);
  const std::size_t columns = stdout_is_terminal() ? terminal_columns(1) : 80;
  const auto tell = [&](const std::filesystem::path& file) {
    if (!request.words.quiet && !request.words.json) tell_file(file);
  };
  finish(findings_of(result, columns), to_json(result), request.words, runner, [&] {
    const auto sheet = runner.options().folder / "sheet.png";
    if (request.sheet) write_sheet(runner, result, sheet), tell(sheet);
    if (!request.film.empty()) write_film(runner, result, request.film), tell(request.film);
  });
}

}  // namespace

void describe_study_sweep(CLI::App& study, StudyAction& action) {
  describe_kind<SweepRequest>(
      study, action, "sweep",
      "Run a script over ranges of its options, or find where a condition begins to hold",
      describe_sweep_words, carry_out_sweep);
}

}  // namespace hackle
