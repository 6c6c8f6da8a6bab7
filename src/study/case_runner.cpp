// SPDX-License-Identifier: MIT
#include "study/case_runner.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <span>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/interrupt.hpp"
#include "base/version.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto pause_between_polls = std::chrono::milliseconds(2);

// The error message of a program without what it says besides.
std::string last_error(const std::string& text) {
  const std::size_t at = text.find("error: ");
  std::string message = at == std::string::npos ? text : text.substr(at + 7);
  while (!message.empty() && message.back() == '\n') message.pop_back();
  return message.empty() ? "it ended without a word" : message;
}

// What tells whether a file has changed.
std::string facts_of(const fs::path& file) {
  std::error_code failed;
  const auto changed = fs::last_write_time(file, failed).time_since_epoch().count();
  return fmt::format("{} {} {}", file.filename().string(), fs::file_size(file, failed), changed);
}

// The files that a script may read: modules and tables in its folder.
std::vector<std::string> files_beside(const fs::path& script) {
  std::vector<std::string> all;
  std::error_code failed;
  const fs::path folder = script.has_parent_path() ? script.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const fs::path ending = entry.path().extension();
    if (entry.path().filename() == script.filename()) continue;
    if (ending == ".lua" || ending == ".csv" || ending == ".dxf" || ending == ".json")
      all.push_back(facts_of(entry.path()));
  }
  std::ranges::sort(all);
  return all;
}

Outcome outcome_of(const Case& one, const ChildResult& result) {
  Outcome outcome{.setting = one,
                  .exit_code = result.exit_code,
                  .wall = result.wall,
                  .cpu = result.cpu,
                  .peak_bytes = result.peak_bytes};
  if (result.timed_out) {
    outcome.state = CaseState::stopped;
    outcome.reason = fmt::format("stopped after {:.1f} s", result.wall);
    return outcome;
  }
  outcome.told = Json::parse(result.out, nullptr, false);
  const bool told = result.exit_code == 0 && outcome.told.is_object();
  outcome.state = told ? CaseState::finished : CaseState::failed;
  if (!told) {
    outcome.told = nullptr;
    outcome.reason = last_error(result.error);
  }
  return outcome;
}

}  // namespace

// The cases that wait, and those that run.
struct CaseRunner::Bench {
  std::deque<std::size_t> waiting;
  std::vector<std::pair<std::size_t, ChildProcess>> running;

  // Returns the results of those that have ended since.
  std::vector<std::pair<std::size_t, ChildResult>> ended() {
    std::vector<std::pair<std::size_t, ChildResult>> all;
    std::vector<std::pair<std::size_t, ChildProcess>> still;
    for (auto& [number, child] : running)
      if (auto result = child.poll())
        all.emplace_back(number, *std::move(result));
      else
        still.emplace_back(number, std::move(child));
    running.swap(still);
    return all;
  }
};

CaseRunner::CaseRunner(StudyScript script, RunnerOptions options)
    : script_(std::move(script)),
      options_(std::move(options)),
      text_(read_text(script_.path)),
      beside_(files_beside(script_.path)) {
}

std::string CaseRunner::key_of(const Case& one) const {
  const Json inputs{{"program", {version(), git_hash(), facts_of(script_.program)}},
                    {"script", text_},
                    {"beside", beside_},
                    {"settings", joined(script_.settings, one.settings)},
                    {"arguments", script_.arguments},
                    {"sample_at", one.sample_at},
                    {"pictures", one.with_pictures},
                    {"repeat", one.repeat},
                    {"last_picture", one.with_last_picture}};
  Hash hash;
  hash.add(std::span<const char>(inputs.dump(-1, ' ', false, Json::error_handler_t::replace)));
  return hash.hex();
}

fs::path CaseRunner::folder_of(const Case& one) const {
  return options_.folder / "cases" / key_of(one);
}

fs::path CaseRunner::picture_of(const Case& one) const {
  return folder_of(one) / "last.png";
}

fs::path CaseRunner::file_of(const Case& one) const {
  fs::path file = folder_of(one);
  file += ".json";
  return file;
}

std::vector<std::string> CaseRunner::words_of(const Case& one, int threads) const {
  std::vector<std::string> words{
      script_.program.string(), "run", script_.path.string(), "--json", "--fresh", "--force",
      "--checkpoint",           "0s"};
  words.insert(words.end(), {"-j", std::to_string(threads), "-o", folder_of(one).string(),
                             "--sample", fmt::format("{}", one.sample_at)});
  if (!one.with_pictures) words.emplace_back("--bare");
  if (one.with_last_picture) words.insert(words.end(), {"--picture", picture_of(one).string()});
  for (const auto& [key, value] : joined(script_.settings, one.settings))
    words.insert(words.end(), {"--set", fmt::format("{}={}", key, value)});
  if (!script_.arguments.empty()) words.emplace_back("--");
  words.insert(words.end(), script_.arguments.begin(), script_.arguments.end());
  return words;
}

bool CaseRunner::recall(const Case& one, Outcome& outcome) const {
  std::error_code ignored;
  const fs::path file = file_of(one);
  if (one.with_last_picture && !fs::is_regular_file(picture_of(one), ignored)) return false;
  if (options_.fresh || !fs::is_regular_file(file, ignored)) return false;
  const Json kept = Json::parse(read_text(file), nullptr, false);
  if (!kept.is_object() || !kept.contains("told")) return false;
  outcome = {.setting = one,
             .state = kept.value("finished", false) ? CaseState::finished : CaseState::failed,
             .exit_code = kept.value("exit_code", 0),
             .reason = kept.value("reason", std::string()),
             .wall = kept.value("wall_s", 0.0),
             .cpu = kept.value("cpu_s", 0.0),
             .peak_bytes = kept.value("bytes", std::uint64_t{0}),
             .told = kept["told"]};
  return true;
}

// A case that was stopped for its time is not kept: it may be worth more another time.
void CaseRunner::keep(const Outcome& outcome) const {
  if (outcome.state == CaseState::stopped) return;
  const Json kept{{"settings", joined(script_.settings, outcome.setting.settings)},
                  {"finished", outcome.finished()},
                  {"exit_code", outcome.exit_code},
                  {"reason", outcome.reason},
                  {"wall_s", outcome.wall},
                  {"cpu_s", outcome.cpu},
                  {"bytes", outcome.peak_bytes},
                  {"told", outcome.told}};
  write_text(file_of(outcome.setting),
             kept.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::vector<Outcome> CaseRunner::run(std::span<const Case> cases, const std::string& what,
                                     double time_limit) {
  return run(cases, what, time_limit, std::clamp(options_.threads_per_case, 1, options_.threads));
}

Outcome CaseRunner::run_alone(const Case& one, const std::string& what) {
  return run(std::span(&one, 1), what, std::numeric_limits<double>::infinity(), options_.threads)
      .front();
}

std::vector<Outcome> CaseRunner::run(std::span<const Case> cases, const std::string& what,
                                     double time_limit, int threads_per_case) {
  std::vector<Outcome> outcomes(cases.size());
  Bench bench;
  for (std::size_t k = 0; k < cases.size(); ++k)
    if (!recall(cases[k], outcomes[k])) bench.waiting.push_back(k);
  const std::size_t all = bench.waiting.size();
  const auto at_once = static_cast<std::size_t>(std::max(1, options_.threads / threads_per_case));
  Progress progress(options_.talk);
  std::size_t done = 0;
  while (done < all) {
    throw_if_interrupted();
    while (!bench.waiting.empty() && bench.running.size() < at_once) {
      const std::size_t next = bench.waiting.front();
      bench.waiting.pop_front();
      make_folder_of(file_of(cases[next]));
      bench.running.emplace_back(next,
                                 ChildProcess(words_of(cases[next], threads_per_case), time_limit));
    }
    for (auto& [number, result] : bench.ended()) {
      outcomes[number] = outcome_of(cases[number], result);
      keep(outcomes[number]);
      ++done;
      ++runs_;
    }
    const double fraction = static_cast<double>(done) / static_cast<double>(all);
    if (progress.due(fraction))
      progress.show(fraction, fmt::format("{}: {} of {}", what, done, all));
    std::this_thread::sleep_for(pause_between_polls);
  }
  return outcomes;
}

const Outcome& finished(const Outcome& outcome) {
  if (outcome.finished()) return outcome;
  throw Error(ErrorKind::run_failed,
              fmt::format("the run with {} did not finish: {}", name_of(outcome.setting.settings),
                          outcome.reason),
              "hackle run tells more");
}

}  // namespace hackle
