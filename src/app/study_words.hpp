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

// Returns the exit code of work that hears Ctrl-C; its errors are told.
int carried_out(const std::function<void()>& work);

// Adds SCRIPT, -o, -j, -q, --json and --fresh to a kind.
void describe_study_words(CLI::App& kind, StudyWords& words);
// Adds the same without SCRIPT.
void describe_study_options(CLI::App& kind, StudyWords& words, const std::string& folder);

// Adds --set for values of every run.
void describe_set(CLI::App& kind, StudyWords& words);

// Adds --for, names of quantities.
void describe_quantities(CLI::App& kind, std::vector<std::string>& names);

// Writes the findings, and prints them: the text, or the JSON object.
void finish(const StudyFindings& findings, const nlohmann::ordered_json& json,
            const StudyWords& words, const CaseRunner& runner);
void finish(const StudyFindings& findings, const nlohmann::ordered_json& json,
            const StudyWords& words, const std::filesystem::path& folder);

// Returns the options that the script declares. Throws what Console::run_file throws.
std::set<std::string> declared_options(const StudyWords& words,
                                       const std::vector<std::string>& arguments);

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
