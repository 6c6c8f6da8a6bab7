// SPDX-License-Identifier: MIT
#include "study/features.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "study/case_claim.hpp"
#include "study/instruction_count.hpp"

namespace hackle {
namespace {

using enum FeatureKind;
using Json = nlohmann::ordered_json;

constexpr auto all_features = std::to_array<FeatureRow>({
    {"none", base, "the plate with a crack and loads on two edges"},
    {"alpha_0", absent, "alpha = 0"},
    {"damping_0", absent, "damping with rate 0"},
    {"fidelity_0", absent, "fidelity = 0"},
    {"alpha", kernel, "toughening by compression"},
    {"scatter", kernel, "scatter of the strength"},
    {"no_fail", kernel, "a no-fail zone"},
    {"inclusion", kernel, "an inclusion of another material"},
    {"graded", kernel, "16 levels of stiffness"},
    {"surface", kernel, "correction of surfaces by energy"},
    {"area", kernel, "quadrature by areas"},
    {"conical", kernel, "a conical micromodulus"},
    {"f32", kernel, "single precision"},
    {"fused", kernel, "fused multiply-add"},
    {"fidelity", kernel, "linearised below half of s0"},
    {"next_step", kernel, "bonds break in the next step"},
    {"damping", term, "damping of all motion"},
    {"stiffness_damping", term, "damping of stretch"},
    {"heat", term, "a constant temperature change"},
    {"heating", term, "a temperature that changes"},
    {"late_load", term, "a load that has not begun"},
    {"load_function", term, "a load by a function of time"},
    {"clamp", term, "a clamped edge"},
    {"foundation", term, "an elastic foundation"},
    {"absorb", term, "an absorbing edge"},
    {"contact", term, "contact of crack faces and fragments"},
    {"impact", term, "an impactor"},
    {"platen", term, "a platen"},
    {"log_steps", output, "a table with a row every step"},
    {"log_energy", output, "a table of energies every 10 steps"},
    {"callback", output, "a function of the script every step"},
    {"record", output, "a record every 10 steps"},
    {"movie", output, "an MP4 with a frame every 10 steps"},
    {"gif", output, "a GIF with a frame every 10 steps"},
    {"picture", output, "a picture of damage"},
    {"stress_picture", output, "a picture of stress"},
});

}  // namespace

std::span<const FeatureRow> feature_rows() {
  return all_features;
}

std::vector<FeatureRow> features_named(const std::vector<std::string>& names) {
  if (names.empty()) return {all_features.begin(), all_features.end()};
  std::vector<std::string_view> known;
  known.reserve(all_features.size());
  for (const FeatureRow& row : all_features) known.push_back(row.name);
  std::vector<FeatureRow> chosen{all_features.front()};
  Problems problems;
  for (const std::string& name : names) {
    const auto row = std::ranges::find(all_features, name, &FeatureRow::name);
    if (row == all_features.end())
      problems.add(fmt::format("there is no feature '{}'{}", name, did_you_mean(name, known)),
                   "there are " + comma_list(known));
    else if (row->kind != base)
      chosen.push_back(*row);
  }
  problems.throw_if_any(ErrorKind::usage);
  return chosen;
}

namespace {

// Steps of a run that only starts, and of two whose difference counts; those that valgrind counts.
constexpr std::array<int, 3> steps_of_runs{0, 50, 550};
constexpr int few_counted = 20, many_counted = 40;

Case case_of(const FeatureRow& row, int steps, int round) {
  return {.settings = {{"feature", std::string(row.name)},
                       {"steps", std::to_string(steps)},
                       {"round", std::to_string(round)}},
          .with_pictures = true};
}

// Of several runs alike: other processes only add.
struct Least {
  double cpu = 0.0;
  std::uint64_t bytes = 0;
  Outcome last;

  void add(const Outcome& one) {
    const bool first = cpu == 0.0;
    cpu = first ? one.cpu : std::min(cpu, one.cpu);
    bytes = first ? one.peak_bytes : std::min(bytes, one.peak_bytes);
    if (first || last.finished()) last = one;
  }
};

using Runs = std::array<Least, steps_of_runs.size()>;

// Runs all rows in every round, so that a slow while of the machine meets all of them.
std::vector<Runs> runs_of(CaseRunner& runner, const std::vector<FeatureRow>& rows, int rounds) {
  std::vector<Case> cases;
  for (int round = 1; round <= rounds; ++round)
    for (const FeatureRow& row : rows)
      for (const int steps : steps_of_runs) cases.push_back(case_of(row, steps, round));
  const auto outcomes = runner.run(cases, "features");
  std::vector<Runs> runs(rows.size());
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    runs[k / steps_of_runs.size() % rows.size()][k % steps_of_runs.size()].add(outcomes[k]);
  return runs;
}

std::vector<std::string> words_for_counting(const CaseRunner& runner, const FeatureRow& row,
                                            int steps) {
  const StudyScript& script = runner.script();
  std::vector<std::string> words{script.program.string(),
                                 "run",
                                 script.path.string(),
                                 "--force",
                                 "--fresh",
                                 "-q",
                                 "--checkpoint",
                                 "0s",
                                 "-j",
                                 "1"};
  words.insert(words.end(), {"-o", (runner.options().folder / "counted").string()});
  for (const auto& [key, value] : case_of(row, steps, 1).settings)
    words.insert(words.end(), {"--set", fmt::format("{}={}", key, value)});
  return words;
}

void count_into(FeatureCost& cost, const CaseRunner& runner, const FeatureRow& row, double nodes,
                const std::filesystem::path& valgrind) {
  const auto counted = [&](int steps) {
    return count_instructions(valgrind, words_for_counting(runner, row, steps));
  };
  cost.start_instructions = counted(0);
  const auto less = counted(few_counted), more = counted(many_counted);
  if (less && more) cost.instructions = (*more - *less) / (nodes * (many_counted - few_counted));
}

void count_all(const CaseRunner& runner, const std::vector<FeatureRow>& rows,
               const std::vector<Runs>& runs, const std::filesystem::path& valgrind,
               std::vector<FeatureCost>& costs) {
  const CaseClaim turn = CaseClaim::in_turn(runner.options().folder / ".counted.lock");
  Progress progress(runner.options().talk);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double fraction = static_cast<double>(k) / static_cast<double>(rows.size());
    if (progress.due(fraction))
      progress.show(fraction, fmt::format("instructions: {} of {}", k, rows.size()));
    if (costs[k].finished)
      count_into(costs[k], runner, rows[k], runs[k][0].last.told["nodes"].get<double>(), valgrind);
  }
}

FeatureCost cost_of(const FeatureRow& row, const Runs& runs) {
  FeatureCost cost{.name = std::string(row.name), .what = std::string(row.sentence)};
  for (const Least& one : runs)
    if (!one.last.finished()) {
      cost.finished = false;
      cost.reason = one.last.reason;
      return cost;
    }
  const auto& [start, less, more] = runs;
  const double nodes = more.last.told["nodes"].get<double>();
  cost.cpu = more.cpu;
  cost.start_cpu = start.cpu;
  cost.ns_per_node_step =
      1e9 * (more.cpu - less.cpu) / (nodes * (steps_of_runs[2] - steps_of_runs[1]));
  cost.bytes = static_cast<std::int64_t>(more.bytes);
  cost.start_bytes = static_cast<std::int64_t>(start.bytes);
  cost.inside = more.last.told["kernel_features"].get<std::vector<std::string>>();
  return cost;
}

std::optional<std::filesystem::path> valgrind_if(bool wanted) {
  if (!wanted) return std::nullopt;
  auto found = find_valgrind();
  if (!found)
    throw Error(ErrorKind::refused, "--instructions needs valgrind, which is not on the PATH",
                "install it, or leave the option out");
  return found;
}

}  // namespace

std::vector<FeatureCost> measure_features(CaseRunner& runner, const std::vector<FeatureRow>& rows,
                                          const FeatureOptions& options) {
  const auto valgrind = valgrind_if(options.count);
  const std::vector<Runs> runs = runs_of(runner, rows, options.rounds);
  std::vector<FeatureCost> costs;
  costs.reserve(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) costs.push_back(cost_of(rows[k], runs[k]));
  if (valgrind) count_all(runner, rows, runs, *valgrind, costs);
  const std::int64_t of_base = costs.front().bytes, at_start = costs.front().start_bytes;
  for (FeatureCost& cost : costs) {
    if (!cost.finished) continue;
    cost.bytes -= of_base;
    cost.start_bytes -= at_start;
  }
  return costs;
}

namespace {

double node_steps_of(const Json& told) {
  double sum = 0.0;
  for (const Json& one : told.contains("simulations") ? told["simulations"] : Json::array({told}))
    sum += one.value("nodes", 0.0) * one.value("steps", 0.0);
  return sum;
}

FeatureCost part_of(const std::string& name, const std::string& what, double seconds,
                    double node_steps) {
  FeatureCost cost{.name = name, .what = what, .cpu = seconds};
  if (node_steps > 0.0) cost.ns_per_node_step = 1e9 * seconds / node_steps;
  return cost;
}

// What the run tells of itself: the terms of its steps, and what it leaves behind.
void add_parts(const Json& told, double node_steps, std::vector<FeatureCost>& costs) {
  const Json& wall = told["wall_s"];
  for (const auto& [name, share] : told["step_shares"].items())
    costs.push_back(part_of(name, "part of the steps of the last simulation",
                            share.get<double>() * wall.value("solve", 0.0), node_steps));
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> stages{
      {{"render", "painting pictures and frames"},
       {"encode", "encoding movies"},
       {"store", "writing records and tables"}}};
  for (const auto& [name, what] : stages)
    if (const double seconds = wall.value(std::string(name), 0.0); seconds > 0.0)
      costs.push_back(part_of(std::string(name), std::string(what), seconds, node_steps));
}

Least least_of_script(CaseRunner& runner, bool pictures, int rounds) {
  // Rounds are told apart by the time of their sample, which none reads.
  Least least;
  for (int round = 0; round < rounds; ++round) {
    const Case one{.sample_at = 1e-15 * round, .with_pictures = pictures};
    least.add(finished(runner.run_alone(one, pictures ? "as written" : "bare")));
  }
  return least;
}

}  // namespace

std::vector<FeatureCost> measure_script(CaseRunner& runner, const FeatureOptions& options) {
  const Least bare = least_of_script(runner, false, options.rounds);
  const Least whole = least_of_script(runner, true, options.rounds);
  const double node_steps = node_steps_of(bare.last.told);
  std::vector<FeatureCost> costs{
      part_of("bare", "without pictures and movies", bare.cpu, node_steps),
      part_of("as written", "with all that it leaves behind", whole.cpu, node_steps)};
  costs[0].inside = bare.last.told.value("kernel_features", std::vector<std::string>());
  costs[1].inside = costs[0].inside;
  costs[1].bytes = static_cast<std::int64_t>(whole.bytes) - static_cast<std::int64_t>(bare.bytes);
  if (whole.last.told.contains("wall_s")) add_parts(whole.last.told, node_steps, costs);
  return costs;
}

}  // namespace hackle
