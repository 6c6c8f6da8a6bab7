// SPDX-License-Identifier: MIT
// hackle study KIND: many runs of a script compared. Each kind has a file of its own,
// study_KIND.cpp, that describes its command and carries it out.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "solver/simulation.hpp"
#include "study/case_runner.hpp"
#include "study/study_files.hpp"

namespace hackle {

// What the chosen kind does, with the arguments after --; returns the exit code.
using StudyAction = std::function<int(const std::vector<std::string>& arguments)>;

// The options that every kind has.
struct StudyWords {
  std::filesystem::path script;
  std::filesystem::path folder;  // "": out/study/<name of the script>
  std::vector<std::string> settings;
  Execution execution;
  bool json = false;
  bool quiet = false;
  bool fresh = false;
};

// Returns the exit code of work that hears Ctrl-C; its errors are told, by rank 0 if all ranks meet
// the same.
int carried_out(const std::function<void()>& work);

// Adds SCRIPT, -o, -j, -q, --json and --fresh to a kind.
void describe_study_words(CLI::App& kind, StudyWords& words);
// Adds the same without SCRIPT.
void describe_study_options(CLI::App& kind, StudyWords& words, const std::string& folder);

// Adds --set for values of every run.
void describe_set(CLI::App& kind, StudyWords& words);

// Adds --for, names of quantities.
void describe_quantities(CLI::App& kind, std::vector<std::string>& names);

// Writes the findings, prints them, as text or as a JSON object, and then calls `more`, which
// writes other files. How processes have shared the runs is added. Only rank 0 does so; of a job
// array the first task that comes here, after which the others find what they would write.
// Processes that come at the same time do it in turn.
void finish(const StudyFindings& findings, nlohmann::ordered_json json, const StudyWords& words,
            const CaseRunner& runner, const std::function<void()>& more = {});
void finish(const StudyFindings& findings, nlohmann::ordered_json json, const StudyWords& words,
            const std::filesystem::path& folder, const Sharing& sharing,
            const std::function<void()>& more = {});

// Returns the options that the script declares. Throws what Console::run_file throws.
std::set<std::string> declared_options(const StudyWords& words,
                                       const std::vector<std::string>& arguments);

// Returns the options of a runner: with threads of its share of the machine's cores unless -j is
// given, and silent in ranks above 0.
RunnerOptions runner_options_of(const StudyWords& words, const std::filesystem::path& folder);

// Returns a runner of the script. Throws Error (usage, files).
CaseRunner runner_of(const StudyWords& words, const std::vector<std::string>& arguments);

// Adds one kind, whose own options are kept in a Request. `carry_out` is called with Ctrl-C heard,
// and its errors are told.
template <class Request>
void describe_kind(CLI::App& study, StudyAction& action, const std::string& name,
                   const std::string& sentence, void (*describe)(CLI::App&, Request&),
                   void (*carry_out)(const Request&, const std::vector<std::string>&)) {
  CLI::App* kind = study.add_subcommand(name, sentence);
  const auto request = std::make_shared<Request>();
  describe(*kind, *request);
  kind->callback([&action, request, carry_out] {
    action = [request, carry_out](const std::vector<std::string>& arguments) {
      return carried_out([&] { carry_out(*request, arguments); });
    };
  });
}

}  // namespace hackle
