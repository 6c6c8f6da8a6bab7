// SPDX-License-Identifier: MIT
// The folder in which outcomes of cases are kept, for this study and others of the same script.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/case.hpp"

namespace hackle {

class CaseStore {
 public:
  // `folder` is that of the study; outcomes are kept in its folder cases/. Throws Error (files) if
  // the script cannot be read.
  CaseStore(StudyScript script, std::filesystem::path folder);

  const StudyScript& script() const { return script_; }

  // Returns the hash of all that decides the outcome of a case: the program, the script, the files
  // beside it, the settings.
  std::string key_of(const Case& one) const;
  // Returns the folder of the files of a case.
  std::filesystem::path folder_of(const Case& one) const;
  // Returns the file of its last picture, which exists only if the case asked for it.
  std::filesystem::path picture_of(const Case& one) const;
  // Returns the file that is locked while a process runs the case.
  std::filesystem::path lock_of(const Case& one) const;

  // Returns the outcome, if it is kept. That of a case which was stopped counts only if it had
  // `time_limit`, s, or more.
  std::optional<Outcome> outcome_of(const Case& one, double time_limit) const;
  // `time_limit` is the one that the case had. Throws Error (files).
  void keep(const Outcome& outcome, double time_limit) const;

 private:
  std::filesystem::path file_of(const Case& one, const char* ending) const;

  StudyScript script_;
  std::filesystem::path folder_;
  std::string text_;                 // of the script
  std::vector<std::string> beside_;  // facts of the files in its folder
};

}  // namespace hackle
