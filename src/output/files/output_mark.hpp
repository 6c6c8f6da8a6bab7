// SPDX-License-Identifier: MIT
// How far an output has come, so that another program can go on with it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hackle {

struct OutputMark {
  std::filesystem::path file;
  std::int64_t pieces = 0;          // frames, records or rows that it has
  double start = 0.0;               // s, of its schedule
  std::int64_t next = 0;            // number of the time that its schedule waits for
  bool complete = false;            // the file is finished
  std::string note = {};            // what it has noted for its next piece, in its own form
  std::vector<double> memory = {};  // numbers that its next pieces depend on
};

}  // namespace hackle
