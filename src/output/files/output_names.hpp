// SPDX-License-Identifier: MIT
// One writer a file: which files the simulations and functions of a session write, by the names by
// which the system knows them.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace hackle {

enum class FileKind { movie, run_file, picture, script, text };

// Throws Error (refused) unless the name ends as one of the kind does, with the endings it may have
// and the nearest; `who` names the call. The ending of a text is free.
void check_ending(const std::string& who, const std::filesystem::path& path, FileKind kind);

class OutputNames {
 public:
  // Where in a script something is asked for, e.g. "a.lua:12"; nothing where there is no script.
  std::function<std::string()> place;
  // What is complete may be written again by the same kind: a person does so on purpose.
  bool replaces_complete = false;
  // Nothing is written: what other programs write does not matter.
  bool rehearses = false;

  // From now on `path` is written by `who`, with all that goes with its kind: the name that it
  // bears while it is not complete, the sidecar. Pictures, scripts and texts may be written again
  // by their own kind. Throws Error (refused), naming the first writer, when any of it is somebody
  // else's, and Error (files) when another program is writing it.
  void claim(const std::string& who, const std::filesystem::path& path, FileKind kind);
  // The same for a file that is going to be written now: first refuses a wrong ending, and what
  // cannot be written.
  void claim_checked(const std::string& who, const std::filesystem::path& path, FileKind kind);
  // Gives back what was claimed last, by a call that is refused after all.
  void take_back(const std::filesystem::path& path);
  // It is complete.
  void complete(const std::filesystem::path& path);
  bool is_claimed(const std::filesystem::path& path) const;

 private:
  using Names = std::set<std::filesystem::path>;
  struct Claim {
    std::string who, place;
    std::filesystem::path path;
    FileKind kind;
    Names own;  // of the file itself
    Names all;  // and of what goes with it
    bool is_complete = false;
  };
  bool may_replace(const Claim& claim, const Claim& former) const;

  std::vector<Claim> claims_;
};

}  // namespace hackle
