// SPDX-License-Identifier: MIT
#include "app/study_words.hpp"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/ranks/launcher.hpp"
#include "base/streams.hpp"
#include "console/console.hpp"
#include "study/case_claim.hpp"
#include "study/quantity.hpp"

namespace hackle {
namespace {

constexpr int most_threads = 1024;

Settings settings_of(const std::vector<std::string>& words) {
  Settings settings;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    settings[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return settings;
}

bool is_reported(const nlohmann::ordered_json& json, const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && read_text(file) == findings_text(json);
}

// What all ranks meet is told by rank 0, which comes to it at about the same time: mpirun then ends
// the others.
int exit_code_of_rank(const Launcher& launcher, const std::function<int()>& work) {
  constexpr int pauses = 30;
  constexpr std::chrono::milliseconds pause(50);
  try {
    return work();
  } catch (const Error& error) {
    for (int k = 0; k < pauses && !interrupted(); ++k) std::this_thread::sleep_for(pause);
    const bool is_of_all = error.kind() == ErrorKind::usage || error.kind() == ErrorKind::script ||
                           error.kind() == ErrorKind::refused;
    if (interrupted() || is_of_all) return static_cast<int>(error.kind());
    return exit_code_of([&]() -> int {
      say("rank {} of {}: ", launcher.rank, launcher.count);
      throw error;
    });
  }
}

}  // namespace

void describe_study_words(CLI::App& kind, StudyWords& words) {
  kind.add_option("SCRIPT", words.script, "The script")->required();
  describe_study_options(kind, words, "out/study/<name of the script>");
}

void describe_study_options(CLI::App& kind, StudyWords& words, const std::string& folder) {
  kind.add_option("-o,--output", words.folder,
                  fmt::format("Folder of the study, from which it goes on ({})", folder))
      ->type_name("DIR");
  kind.add_option("-j,--threads", words.execution.threads,
                  "Number of threads of all runs together (one per core; with mpirun, the "
                  "process's share of the cores)")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads));
  kind.add_flag("--json", words.json, "Print one JSON object with the results on stdout");
  kind.add_flag("-q,--quiet", words.quiet, "Print only results and errors");
  kind.add_flag("--fresh", words.fresh, "Run again what an earlier study has run");
}

void describe_set(CLI::App& kind, StudyWords& words) {
  const auto check = [](const std::string& setting) {
    const std::size_t equals = setting.find('=');
    return equals == 0 || equals == std::string::npos ? "'" + setting + "' is not key=value" : "";
  };
  kind.add_option("--set", words.settings,
                  "Override an option of the script, simulate.KEY of every simulate, or "
                  "material.KEY and scatter.KEY of its plate, in all runs; repeatable")
      ->type_name("key=value")
      ->check(check, "")
      ->take_all()
      ->allow_extra_args(false);
}

void describe_quantities(CLI::App& kind, std::vector<std::string>& names) {
  std::string known;
  for (const QuantityRow& row : quantity_rows())
    known += fmt::format("{}{}", known.empty() ? "" : ", ", row.name);
  kind.add_option(
          "--for", names,
          fmt::format("What is compared (all): {}, and expect.NAME of the script's own", known))
      ->type_name("NAME,...")
      ->delimiter(',');
}

void finish(const StudyFindings& findings, nlohmann::ordered_json json, const StudyWords& words,
            const CaseRunner& runner, const std::function<void()>& more) {
  finish(findings, std::move(json), words, runner.options().folder, runner.sharing(), more);
}

void finish(const StudyFindings& findings, nlohmann::ordered_json json, const StudyWords& words,
            const std::filesystem::path& folder, const Sharing& sharing,
            const std::function<void()>& more) {
  const Launcher launcher = this_launcher();
  if (launcher.rank > 0) return;
  if (auto shared = sharing.json(); !shared.is_null()) json["sharing"] = std::move(shared);
  const CaseClaim turn = CaseClaim::in_turn(folder / ".report.lock");
  if (launcher.is_in_array() && is_reported(json, folder / (findings.name + ".json"))) {
    if (!words.quiet) say("the report of the array is in {}\n", folder.string());
    return;
  }
  const auto files = write_findings(findings, json, folder);
  if (words.json)
    print_out("{}\n", json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  else
    print_out("{}{}", findings.text, sharing.text());
  flush(stdout);
  if (!words.quiet && !words.json)
    for (const auto& file : files) tell_file(file);
  if (more) more();
}

std::set<std::string> declared_options(const StudyWords& words,
                                       const std::vector<std::string>& arguments) {
  ConsoleSettings settings;
  settings.purpose = Purpose::options;
  settings.talk = Talk::quiet;
  settings.print_to_stderr = true;
  Console console(settings);
  console.run_file(words.script, arguments);
  std::set<std::string> names;
  for (const auto& [name, fallback] : console.options()) names.insert(name);
  return names;
}

RunnerOptions runner_options_of(const StudyWords& words, const std::filesystem::path& folder) {
  const Launcher launcher = this_launcher();
  const bool is_silent = words.quiet || words.json || launcher.rank > 0;
  return {
      .folder = folder,
      .threads = words.execution.threads > 0 ? words.execution.threads : share_of_cores(launcher),
      .talk = talk(is_silent),
      .notes = !words.quiet,
      .fresh = words.fresh,
      .launcher = launcher};
}

CaseRunner runner_of(const StudyWords& words, const std::vector<std::string>& arguments) {
  const StudyScript script{.program = this_program(),
                           .path = words.script,
                           .settings = settings_of(words.settings),
                           .arguments = arguments};
  const auto folder = words.folder.empty()
                          ? std::filesystem::path("out/study") / words.script.stem()
                          : words.folder;
  return {script, runner_options_of(words, folder)};
}

int carried_out(const std::function<void()>& work) {
  const InterruptHandler handler;
  const auto heard = [&] {
    work();
    return 0;
  };
  const Launcher launcher = this_launcher();
  return launcher.rank == 0 ? exit_code_of(heard) : exit_code_of_rank(launcher, heard);
}

}  // namespace hackle
