// SPDX-License-Identifier: MIT
// hackle study ensemble: many runs that differ in their last digits, or in scattered strength.
#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "study/ensemble_report.hpp"
#include "study/study_files.hpp"

namespace hackle {
namespace {

constexpr int max_runs = 10000;

struct EnsembleRequest {
  StudyWords words;
  int runs = 32;
  std::string change;   // of the stiffness: "1e-5", "0.001%" or "bits", as does ""
  std::string scatter;  // "1%", "0.01" or "own"; "": the stiffness is changed
  std::string within;   // "0.5mm"; "": one horizon
  std::vector<std::string> quantities;
};

// A number and what follows it.
std::pair<double, std::string_view> number_and_rest(std::string_view text, const char* option) {
  double number = 0.0;
  const auto [rest, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc())
    throw Error(ErrorKind::usage, fmt::format("{} {}: it begins with no number", option, text));
  return {number, text.substr(static_cast<std::size_t>(rest - text.data()))};
}

double length_in(std::string_view text) {
  auto [number, unit] = number_and_rest(text, "--within");
  if (unit.starts_with('*')) unit.remove_prefix(1);
  for (const Unit& one : units())
    if (one.dimension == "length" && one.name == unit && number > 0.0) return number * one.factor;
  throw Error(ErrorKind::usage, fmt::format("--within {}: not a length above 0", text),
              "as in --within 0.5mm");
}

// Throws Error (usage) unless it is a share above 0 and up to `max`.
double share_in(std::string_view text, const char* option, double max, const char* remedy) {
  const auto [number, unit] = number_and_rest(text, option);
  const double share = unit == "%" ? 0.01 * number : number;
  if ((unit.empty() || unit == "%") && share > 0.0 && share <= max) return share;
  throw Error(ErrorKind::usage,
              fmt::format("{} {}: it must be above 0, and at most {:g}", option, text, max),
              remedy);
}

void set_change(const EnsembleRequest& request, EnsembleOptions& options) {
  if (request.change == "bits")
    options.size = 0.0;
  else if (!request.change.empty())
    options.size = share_in(request.change, "--change", 0.1, "as in --change 1e-5, or bits");
  if (request.scatter.empty()) return;
  options.change = request.scatter == "own" ? Change::own_scatter : Change::strength;
  if (options.change == Change::strength)
    options.size = share_in(request.scatter, "--scatter", 0.3,
                            "as in --scatter 1%, or own for other seeds of the plate's own");
}

std::vector<QuantityRow> numbers_named(const std::vector<std::string>& names) {
  std::vector<QuantityRow> rows = quantities_named(names);
  Problems problems;
  for (const QuantityRow& row : rows)
    if (row.kind != ComparedAs::number && row.kind != ComparedAs::count)
      problems.add(fmt::format("--for {}: it is no number", row.name),
                   "an ensemble has statistics of numbers; it compares paths by itself");
  problems.throw_if_any(ErrorKind::usage);
  return rows;
}

EnsembleOptions ensemble_options_of(const EnsembleRequest& request) {
  EnsembleOptions options{.runs = request.runs};
  set_change(request, options);
  if (!request.within.empty()) options.within = length_in(request.within);
  if (!request.quantities.empty()) options.quantities = numbers_named(request.quantities);
  return options;
}

void describe_ensemble(CLI::App& kind, EnsembleRequest& request) {
  describe_study_words(kind, request.words);
  describe_set(kind, request.words);
  kind.add_option("--runs", request.runs, "How many runs (32)")
      ->type_name("N")
      ->check(CLI::Range(2, max_runs));
  auto* change = kind.add_option("--change", request.change,
                                 "Change E by at most this share, as in 1e-5, or `bits`: its last "
                                 "bits, by 2^-50 from run to run in f64 (bits)");
  change->type_name("SHARE");
  kind.add_option("--scatter", request.scatter,
                  "Instead scatter the strength by this standard deviation, as in 1%, with another "
                  "seed in each run, or `own`: the plate's own scatter, with other seeds")
      ->type_name("SHARE")
      ->excludes(change);
  kind.add_option("--within", request.within,
                  "Paths that are nearer than this agree, as in 0.5mm (one horizon)")
      ->type_name("LENGTH");
  describe_quantities(kind, request.quantities);
  kind.footer(
      "It says until when the paths of all runs agree, which numbers one run tells, and of "
      "the others mean, 95 % interval and range; ensemble_cracked.png shows how often each "
      "point was cracked.");
}

void study_ensemble(const EnsembleRequest& request, const std::vector<std::string>& arguments) {
  const EnsembleOptions options = ensemble_options_of(request);
  CaseRunner runner = runner_of(request.words, arguments);
  const Ensemble all = ensemble(runner, options);
  finish({"ensemble", text_of(all), table_of(all), {chart_of(all)}}, to_json(all), request.words,
         runner, [&] {
           if (!all.has_cracks()) return;
           const auto map = runner.options().folder / "ensemble_cracked.png";
           write_picture(all.frequency,
                         fmt::format("{}: where {} runs cracked",
                                     request.words.script.stem().string(), all.runs.size()),
                         map);
           if (!request.words.quiet && !request.words.json) tell_file(map);
         });
}

}  // namespace

void describe_study_ensemble(CLI::App& study, StudyAction& action) {
  describe_kind<EnsembleRequest>(study, action, "ensemble",
                                 "Until when runs with other last digits agree, and statistics",
                                 describe_ensemble, study_ensemble);
}

}  // namespace hackle
