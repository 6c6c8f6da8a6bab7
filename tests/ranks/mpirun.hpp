// SPDX-License-Identifier: MIT
// Runs the program as several ranks, in a separate folder.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <sys/wait.h>

#include "support/folder.hpp"
#include "support/skipping.hpp"

namespace hackle::test {

inline bool mpi_is_installed() {
  const auto module = std::filesystem::path(HACKLE_PROGRAM).parent_path().parent_path() /
                      "lib/hackle/hackle_mpi.so";
  return std::filesystem::exists(module) && std::system("command -v mpirun >/dev/null 2>&1") == 0;
}

#define HACKLE_NEEDS_MPI                         \
  HACKLE_NEEDS(hackle::test::mpi_is_installed(), \
               "ranks need Open MPI (openmpi-bin, libopenmpi-dev), and the module built with it")

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Said {
  int code = -1;
  std::string out, err;
};

// What a shell does in the folder; it is killed after some time, which its code shows.
inline Said shell(const Folder& folder, const std::string& command) {
  const std::string all = fmt::format("cd '{}' && timeout -s KILL 100 bash -c '{}' >.out 2>.err",
                                      folder.path.string(), command);
  const int status = std::system(all.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder.path / ".out"),
          text_of(folder.path / ".err")};
}

// The program alone, or as `ranks` processes, more than the cores. Words have no quotes.
inline Said hackle(const Folder& folder, int ranks, const std::string& words) {
  const std::string program = fmt::format("\"{}\" {}", HACKLE_PROGRAM, words);
  if (ranks == 1) return shell(folder, program);
  return shell(folder,
               fmt::format("mpirun --allow-run-as-root --oversubscribe -n {} {}", ranks, program));
}

inline void write(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.path / name) << text;
}

}  // namespace hackle::test
