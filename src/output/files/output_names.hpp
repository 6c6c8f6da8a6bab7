// SPDX-License-Identifier: MIT
// One writer per file: the files that the simulations and functions of a session write, by the
// names under which the system knows them.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace hackle {

enum class FileKind { movie, run_file, checkpoint, picture, script, table, text };

// Throws Error (refused) unless the name has an extension of its kind; the message lists them with
// the nearest; `who` names the calling function. A text may have any extension.
void check_ending(const std::string& who, const std::filesystem::path& path, FileKind kind);

class OutputNames {
 public:
  // Returns the place in a script that requests something, e.g. "a.lua:12"; nothing without a
  // script.
  std::function<std::string()> place;
  // Complete files may be replaced by the same kind: at a prompt this is intended.
  bool replaces_complete = false;
  // Nothing is written, so files of other programs do not matter.
  bool rehearses = false;

  // Reserves `path` for `who`, with the names that belong to its kind: its partial name, its
  // sidecar. Pictures, scripts and texts may be replaced by their own kind. Throws Error (refused),
  // naming the first writer, if any of the names is already reserved, and Error (files) if another
  // program is writing one.
  void claim(const std::string& who, const std::filesystem::path& path, FileKind kind);
  // The same for a file that is going to be written now: first refuses a wrong ending, and what
  // cannot be written.
  void claim_checked(const std::string& who, const std::filesystem::path& path, FileKind kind);
  // Releases the last claim, made by a call that is refused after all.
  void take_back(const std::filesystem::path& path);
  // Marks the file as complete.
  void complete(const std::filesystem::path& path);
  bool is_claimed(const std::filesystem::path& path) const;

 private:
  using Names = std::set<std::filesystem::path>;
  struct Claim {
    std::string who, place;
    std::filesystem::path path;
    FileKind kind;
    Names own;  // of the file itself
    Names all;  // with the names that belong to it
    bool is_complete = false;
  };
  bool may_replace(const Claim& claim, const Claim& former) const;

  std::vector<Claim> claims_;
};

}  // namespace hackle
