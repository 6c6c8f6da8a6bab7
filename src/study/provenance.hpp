// SPDX-License-Identifier: MIT
// Which process ran a case, and when: several may share the work of a study.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "base/ranks/launcher.hpp"

namespace hackle {

struct Provenance {
  std::string machine;      // the name of the host
  int process = 0;          // its id there
  std::string job;          // Launcher::job
  double began = 0.0;       // s since 1970
  bool taken_over = false;  // from a process that ended without an outcome

  bool is_same_process(const Provenance& other) const {
    return process == other.process && machine == other.machine;
  }
};

// Returns that of a case which this process begins now.
Provenance provenance_now(const std::string& job);

// Returns "process 4711 on node3".
std::string process_name(const Provenance& one);

nlohmann::ordered_json to_json(const Provenance& one);
// Values that are missing or of another type are those of an empty one.
Provenance provenance_of(const nlohmann::ordered_json& json);

// The processes that were started as `launcher` tells, `start` being the time at which this one
// began, s since 1970: cases that belong to their work are not of an earlier study.
class StudySession {
 public:
  explicit StudySession(const Launcher& launcher = this_launcher());
  // Returns whether a case was begun since this process started, or by another one of the same
  // launch: up to 10 minutes earlier, because ranks do not start at once and numbers of launches
  // recur; at any time in a job array, whose tasks start when they may.
  bool includes(const Provenance& one) const;
  const std::string& job() const { return job_; }

 private:
  std::string job_;
  double start_, patience_;
};

}  // namespace hackle
