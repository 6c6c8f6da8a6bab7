// SPDX-License-Identifier: MIT
// What a checkpoint of a script holds beside the state of one simulation: all that is needed to run
// the script again up to that point.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/origin.hpp"
#include "output/files/output_folder.hpp"
#include "output/files/output_mark.hpp"

namespace hackle {

struct Continuation {
  // Another simulation of the script and the checkpoint that has its state.
  struct Other {
    int run = 0;
    std::string file;  // in the same folder
    std::string hash;  // of the state
  };

  RunInputs inputs;
  Origin origin;
  std::string journal;
  std::string obstacle;  // why the script cannot be replayed; empty if it can
  int run = 0;           // number of the simulation whose state the checkpoint has
  std::vector<Other> others;
  std::map<int, std::vector<OutputMark>> outputs;  // of simulations, by number
  std::map<int, std::string> summaries;            // JSON, of those that are gone
};

// A file that holds one.
struct Found {
  std::filesystem::path checkpoint;
  Continuation continuation;
};

std::string bytes_of(const Continuation& continuation);
// Throws Error (files) for bytes that are none; `who` names the file.
Continuation continuation_of(const std::string& bytes, const std::filesystem::path& who);

// Returns the checkpoint that a script keeps by itself: of its simulation of that number.
std::filesystem::path automatic_checkpoint(const std::string& script, int number);

// Returns the automatic checkpoints in a folder, of one script or of any if it is empty.
std::vector<std::filesystem::path> automatic_checkpoints(const std::filesystem::path& folder,
                                                         const std::string& script);

// Returns the furthest of the whole automatic checkpoints in a folder, of one script or of any if
// it is empty; files that are damaged are named in `problems`. Throws Error (interrupted).
std::optional<Found> find_continuation(const std::filesystem::path& folder,
                                       const std::string& script,
                                       std::vector<std::string>& problems);

}  // namespace hackle
