// SPDX-License-Identifier: MIT
// The files that a script may reach. Every path from a script is checked here, whether it is given
// to a bound function or to one of Lua's (see standard_library.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hackle {

// Judges the target of a path at the time of the check, following links. It does not cover links
// that somebody else makes between check and opening, hard links, and file systems mounted below
// the folders. A script cannot make links.
class Sandbox {
 public:
  // A script may read below all of `readable` and write below `writable`; with `trust` it may do
  // both everywhere.
  Sandbox(std::vector<std::filesystem::path> readable, std::filesystem::path writable, bool trust);

  // Throws Error (refused) unless a script may read the file: it lies below a readable folder, and
  // is a plain file or does not exist. `who` names the function in the message.
  void check_input(const std::string& who, const std::filesystem::path& path) const;
  // Checks writing likewise, also for the names that belong to a file: its partial name, and the
  // sidecar of a run file.
  void check_output(const std::string& who, const std::filesystem::path& path) const;

 private:
  std::vector<std::filesystem::path> readable_;
  std::filesystem::path writable_;
  bool trust_;
};

}  // namespace hackle
