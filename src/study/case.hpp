// SPDX-License-Identifier: MIT
// One run among the many of a study: what it is run with, and what came of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/provenance.hpp"

namespace hackle {

// Values of --set: options of the script, simulate.KEY, material.KEY, scatter.KEY.
using Settings = std::map<std::string, std::string>;

// Returns "spacing 0.25 mm, m 4, f32" for a person; "as written" for none.
std::string name_of(const Settings& settings);

// Returns `first` with the values of `second` in it, which win.
Settings joined(Settings first, const Settings& second);

// The script that a study runs again and again.
struct StudyScript {
  std::filesystem::path program;       // hackle
  std::filesystem::path path;          // of the script
  Settings settings;                   // of every run
  std::vector<std::string> arguments;  // after --
};

// How a study runs it.
struct Case {
  Settings settings;               // beside those of every run
  double sample_at = 0.0;          // s, when the displacements are compared
  bool with_pictures = false;      // makes the movies and pictures of the script too
  int repeat = 0;                  // the same once more, for its time
  bool with_last_picture = false;  // makes last.png of the last state, in the folder of the case
};

enum class CaseState {
  finished,
  failed,   // the run ended with an error
  stopped,  // it took longer than it could be worth
};

struct Outcome {
  Case setting;
  CaseState state = CaseState::failed;
  int exit_code = 0;   // 128 plus the signal that ended it
  std::string reason;  // of a failure, the message of the run
  double wall = 0.0;   // s, of the whole program
  double cpu = 0.0;    // s
  std::uint64_t peak_bytes = 0;
  nlohmann::ordered_json told;  // what hackle run --json says; null if it did not finish
  Provenance made;

  bool finished() const { return state == CaseState::finished; }
};

}  // namespace hackle
