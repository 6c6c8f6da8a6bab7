// SPDX-License-Identifier: MIT
// Runs the cases of a study, each in a program of its own, several at once; what has been run once
// is not run again. Processes with the same study folder share the work: src/study/README.md 1.3.
#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "study/case.hpp"
#include "study/case_store.hpp"
#include "study/sharing.hpp"

namespace hackle {

struct RunnerOptions {
  std::filesystem::path folder;  // of the study; outcomes are kept in its folder cases/
  int threads = 1;               // of all runs of this process together
  int threads_per_case = 1;
  Talk talk = Talk::plain;
  bool notes = false;  // says which cases are taken over from processes that ended
  bool fresh = false;  // does not read what an earlier study has kept
  Launcher launcher = this_launcher();
};

class CaseRunner {
 public:
  // Throws Error (files) if the script cannot be read.
  CaseRunner(StudyScript script, RunnerOptions options);

  // Runs all that is not kept from earlier and that no other process runs, waits for these, shows
  // progress with `what`, and returns the outcomes in the same order. A case is stopped after
  // `time_limit`, s of wall time. Throws Error (interrupted), which keeps what is finished, and
  // Error (files).
  std::vector<Outcome> run(std::span<const Case> cases, const std::string& what,
                           double time_limit = std::numeric_limits<double>::infinity());
  // Runs one, with all threads.
  Outcome run_alone(const Case& one, const std::string& what);

  const StudyScript& script() const { return store_.script(); }
  const RunnerOptions& options() const { return options_; }
  // Returns the number of runs that were not kept from earlier, here and in processes that were
  // started together with this one.
  int runs() const { return sharing_.made_in(session_); }
  // Returns who has run what this object has returned.
  const Sharing& sharing() const { return sharing_; }
  // Returns the folder of the files of a case.
  std::filesystem::path folder_of(const Case& one) const { return store_.folder_of(one); }
  // Returns the file of its last picture, which exists only if the case asked for it.
  std::filesystem::path picture_of(const Case& one) const { return store_.picture_of(one); }

 private:
  std::vector<Outcome> run(std::span<const Case> cases, const std::string& what, double time_limit,
                           int threads_per_case);

  RunnerOptions options_;
  CaseStore store_;
  StudySession session_;
  Sharing sharing_;
};

// Throws Error (run_failed) with the reason if a case that a study cannot do without did not
// finish.
const Outcome& finished(const Outcome& outcome);

}  // namespace hackle
