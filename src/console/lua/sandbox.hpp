// SPDX-License-Identifier: MIT
// Which files a script may reach. Every path that a script names goes through here, whether it is
// given to a function of ours or to one of Lua (see standard_library.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hackle {

// Judges where a path leads when it is asked, links followed. Out of its scope are links that
// somebody else makes between the question and the opening of the file, hard links, and what is
// mounted below the folders. A script cannot make links.
class Sandbox {
 public:
  // A script may read below all of `readable` and write below `writable`. With `trust` it may do
  // both everywhere.
  Sandbox(std::vector<std::filesystem::path> readable, std::filesystem::path writable, bool trust);

  // Throws Error (refused) unless a script may read the file: it lies below a folder that may be
  // read, and it is a plain file or there is none. `who` names the function in the message.
  void check_input(const std::string& who, const std::filesystem::path& path) const;
  // The same for writing, and for the names that go with it: that of a file not yet complete, and
  // of the sidecar of a run file.
  void check_output(const std::string& who, const std::filesystem::path& path) const;

 private:
  std::vector<std::filesystem::path> readable_;
  std::filesystem::path writable_;
  bool trust_;
};

}  // namespace hackle
