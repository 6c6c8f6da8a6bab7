// SPDX-License-Identifier: MIT
#include "app/study_kinds.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"

namespace hackle {

void describe_study(CLI::App& app, StudyAction& action) {
  CLI::App* study = app.add_subcommand("study", "Run a script many times and compare");
  study->require_subcommand(1);
  study->footer(
      "Processes that start the same command share its runs through the folder of the study:\n"
      "mpirun -n N hackle study ..., the tasks of a job array (scripts/cluster), or as many\n"
      "terminals. What one of them leaves when it is killed, another one takes over.");
  describe_study_trade(*study, action);
  describe_study_ensemble(*study, action);
  describe_study_envelope(*study, action);
  describe_study_features(*study, action);
  describe_study_convergence(*study, action);
  describe_study_sweep(*study, action);
  describe_study_fit(*study, action);
}

void check_study_kind(const CLI::App& app, const std::vector<std::string>& words) {
  const bool asks = words.size() > 1 && (words[1] == "-h" || words[1] == "--help");
  if (words.empty() || words[0] != "study" || asks) return;
  std::vector<std::string> names;
  for (const CLI::App* kind : app.get_subcommand("study")->get_subcommands({}))
    names.push_back(kind->get_name());
  const std::string given = words.size() > 1 ? words[1] : "";
  if (std::ranges::find(names, given) != names.end()) return;
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw Error(ErrorKind::usage,
              given.empty()
                  ? "no study is named"
                  : fmt::format("there is no study '{}'{}", given, did_you_mean(given, known)),
              "there are " + comma_list(known));
}

}  // namespace hackle
