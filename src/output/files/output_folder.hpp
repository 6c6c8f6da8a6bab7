// SPDX-License-Identifier: MIT
// The folder of the files of a script. A sweep never overwrites itself: a run with other inputs
// takes a folder of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.hpp"

namespace hackle {

// What a run of a script was given: not its text, which its author changes on purpose.
struct RunInputs {
  std::string script;                            // its file name without folder and extension
  std::map<std::string, std::string> overrides;  // --set key=value
  std::vector<std::string> arguments;
  bool operator==(const RunInputs&) const = default;
};

class OutputFolder {
 public:
  enum class Choice {
    free,   // another folder is taken where this one holds a run with other inputs
    named,  // by the user: then it is refused
    force   // it is taken whatever it holds
  };

  OutputFolder(std::filesystem::path wanted, Choice choice, RunInputs inputs);

  // Called in a folder of which nobody else has hold, before a finished run there is made anew: a
  // program that was killed at its very end may have left what only its continuation would need.
  std::function<void(const std::filesystem::path& folder)> clear;

  // Takes the folder, creates it and leaves the inputs there, in NAME.inputs.json; called before
  // the first file is written. Of several programs, each gets its own. Returns a remark where the
  // folder is not a new one; may be empty. Throws Error (refused), and Error (files), also while
  // another program runs the same script with the same inputs there.
  std::string take();
  // Returns the folder in which a run with the same inputs has begun and not finished, of those
  // that take() would look at.
  std::optional<std::filesystem::path> unfinished() const;
  // Returns whether a script of that name has left a finished run there.
  static bool is_finished(const std::filesystem::path& folder, const std::string& script);
  const RunInputs& inputs() const { return inputs_; }
  // Marks the run as finished in a folder that was taken.
  void finish() const;

  const std::filesystem::path& path() const { return path_; }

 private:
  struct Mark {
    RunInputs inputs;
    bool finished = false;
  };

  std::filesystem::path mark_file() const { return mark_file_in(path_); }
  std::filesystem::path mark_file_in(const std::filesystem::path& folder) const;
  std::filesystem::path folder(int number) const;
  static std::optional<Mark> read_mark(const std::filesystem::path& file);
  void lock();
  std::string found();
  bool leave_mark();
  std::string remark_on(const Mark& former) const;
  [[noreturn]] void refuse(const Mark& former) const;

  std::filesystem::path wanted_;
  std::filesystem::path path_;
  Choice choice_;
  RunInputs inputs_;
  bool taken_ = false;
  std::unique_ptr<HeldFile> lock_;  // of a folder that was taken
};

}  // namespace hackle
