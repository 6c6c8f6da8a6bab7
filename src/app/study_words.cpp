// SPDX-License-Identifier: MIT
#include "app/study_words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/streams.hpp"
#include "console/console.hpp"
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
                  "Number of threads of all runs together (one per core)")
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

void finish(const StudyFindings& findings, const nlohmann::ordered_json& json,
            const StudyWords& words, const CaseRunner& runner) {
  finish(findings, json, words, runner.options().folder);
}

void finish(const StudyFindings& findings, const nlohmann::ordered_json& json,
            const StudyWords& words, const std::filesystem::path& folder) {
  const auto files = write_findings(findings, json, folder);
  if (words.json)
    print_out("{}\n", json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  else
    print_out("{}", findings.text);
  flush(stdout);
  if (words.quiet || words.json) return;
  for (const auto& file : files) tell_file(file);
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

CaseRunner runner_of(const StudyWords& words, const std::vector<std::string>& arguments) {
  const StudyScript script{.program = this_program(),
                           .path = words.script,
                           .settings = settings_of(words.settings),
                           .arguments = arguments};
  const auto folder = words.folder.empty()
                          ? std::filesystem::path("out/study") / words.script.stem()
                          : words.folder;
  return {script, RunnerOptions{.folder = folder,
                                .threads = words.execution.thread_count(),
                                .talk = talk(words.quiet || words.json),
                                .fresh = words.fresh}};
}

int carried_out(const std::function<void()>& work) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    work();
    return 0;
  });
}

}  // namespace hackle
