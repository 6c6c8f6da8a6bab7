// SPDX-License-Identifier: MIT
// Runs the cases of a study, each in a program of its own, several at once; what has been run once
// is not run again.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "study/case.hpp"

namespace hackle {

struct RunnerOptions {
  std::filesystem::path folder;  // of the study; outcomes are kept in its folder cases/
  int threads = 1;               // of all runs together
  int threads_per_case = 1;
  Talk talk = Talk::plain;
  bool fresh = false;  // does not read what is kept
};

class CaseRunner {
 public:
  // Throws Error (files) if the script cannot be read.
  CaseRunner(StudyScript script, RunnerOptions options);

  // Runs all that is not kept from earlier, shows progress with `what`, and returns their outcomes
  // in the same order. A case is stopped after `time_limit`, s of wall time. Throws Error
  // (interrupted), which keeps what is finished, and Error (files).
  std::vector<Outcome> run(std::span<const Case> cases, const std::string& what,
                           double time_limit = std::numeric_limits<double>::infinity());
  // Runs one, with all threads.
  Outcome run_alone(const Case& one, const std::string& what);

  const StudyScript& script() const { return script_; }
  const RunnerOptions& options() const { return options_; }
  int runs() const { return runs_; }  // that were not kept from earlier
  // Returns the folder of the files of a case.
  std::filesystem::path folder_of(const Case& one) const;
  // Returns the file of its last picture, which exists only if the case asked for it.
  std::filesystem::path picture_of(const Case& one) const;

 private:
  struct Bench;  // the cases that run now

  std::string key_of(const Case& one) const;
  std::filesystem::path file_of(const Case& one) const;
  std::vector<std::string> words_of(const Case& one, int threads) const;
  bool recall(const Case& one, Outcome& outcome) const;
  void keep(const Outcome& outcome) const;
  std::vector<Outcome> run(std::span<const Case> cases, const std::string& what, double time_limit,
                           int threads_per_case);

  StudyScript script_;
  RunnerOptions options_;
  std::string text_;                 // of the script
  std::vector<std::string> beside_;  // facts of the files in its folder
  int runs_ = 0;
};

// Throws Error (run_failed) with the reason if a case that a study cannot do without did not
// finish.
const Outcome& finished(const Outcome& outcome);

}  // namespace hackle
