// SPDX-License-Identifier: MIT
#include "study/features.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
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
    {"late_load", absent, "a load that has not begun"},
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

// Steps of the two runs whose difference counts, and of those that valgrind counts.
constexpr int few = 100, many = 300, few_counted = 2, many_counted = 6;

Case case_of(const FeatureRow& row, int steps, int round) {
  return {.settings = {{"feature", std::string(row.name)},
                       {"steps", std::to_string(steps)},
                       {"round", std::to_string(round)}},
          .with_pictures = true};
}

// The least of several runs: other processes only add.
struct Least {
  double cpu = 0.0;
  std::uint64_t bytes = 0;
  Outcome last;
};

Least least_of(CaseRunner& runner, const FeatureRow& row, int steps, int rounds) {
  std::vector<Case> cases;
  for (int round = 1; round <= rounds; ++round) cases.push_back(case_of(row, steps, round));
  const auto outcomes = runner.run(cases, std::string(row.name));
  Least least{outcomes.front().cpu, outcomes.front().peak_bytes, outcomes.front()};
  for (const Outcome& one : outcomes) {
    if (!one.finished()) return {0.0, 0, one};
    least.cpu = std::min(least.cpu, one.cpu);
    least.bytes = std::min(least.bytes, one.peak_bytes);
  }
  return least;
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
    words.insert(words.end(), {"--set", key + "=" + value});
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

FeatureCost cost_of(CaseRunner& runner, const FeatureRow& row, const FeatureOptions& options,
                    const std::optional<std::filesystem::path>& valgrind) {
  FeatureCost cost{.name = std::string(row.name), .what = std::string(row.sentence)};
  const Least start = least_of(runner, row, 0, options.rounds);
  const Least less = least_of(runner, row, few, options.rounds);
  const Least more = least_of(runner, row, many, options.rounds);
  for (const Least* one : {&start, &less, &more})
    if (!one->last.finished()) {
      cost.finished = false;
      cost.reason = one->last.reason;
      return cost;
    }
  const double nodes = more.last.told["nodes"].get<double>();
  cost.cpu = more.cpu;
  cost.start_cpu = start.cpu;
  cost.ns_per_node_step = 1e9 * (more.cpu - less.cpu) / (nodes * (many - few));
  cost.bytes = static_cast<std::int64_t>(more.bytes);
  cost.inside = more.last.told["kernel_features"].get<std::vector<std::string>>();
  if (valgrind) count_into(cost, runner, row, nodes, *valgrind);
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
  std::vector<FeatureCost> costs;
  costs.reserve(rows.size());
  for (const FeatureRow& row : rows) costs.push_back(cost_of(runner, row, options, valgrind));
  const std::int64_t of_base = costs.front().bytes;
  for (FeatureCost& cost : costs)
    if (cost.finished) cost.bytes -= of_base;
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
  for (int round = 1; round <= rounds; ++round) {
    const Case one{.sample_at = 1e-15 * (round - 1), .with_pictures = pictures};
    const std::string what = pictures ? "as written" : "bare";
    least.last = finished(runner.run_alone(one, what));
    least.cpu = round == 1 ? least.last.cpu : std::min(least.cpu, least.last.cpu);
    least.bytes = round == 1 ? least.last.peak_bytes : std::min(least.bytes, least.last.peak_bytes);
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
