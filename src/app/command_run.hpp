// SPDX-License-Identifier: MIT
// hackle run FILE
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/limits.hpp"
#include "console/console.hpp"

namespace hackle {

struct RunRequest {
  std::filesystem::path script;                  // "-": from stdin
  std::string text;                              // of -e, in place of a script
  std::filesystem::path output_folder;           // "": out/<name of the script>
  std::map<std::string, std::string> overrides;  // --set key=value
  std::vector<std::string> arguments;            // after --
  Execution execution;
  Limits limits;
  bool json = false;
  bool bare = false;                // no movies, pictures and records
  std::filesystem::path picture;    // of the last state; "": none
  std::optional<double> sample_at;  // s; with JSON: the paths of the cracks, and displacements then
  bool quiet = false;
  bool force = false;               // earlier files may be overwritten
  bool fresh = false;               // an unfinished run is not continued
  std::filesystem::path resumed;    // a checkpoint or its folder, in place of a script
  double checkpoint_every = 600.0;  // s of wall time; 0: none
  bool interactive = false;         // the prompt goes on after it
  double patience = 120.0;          // s that a rank waits for another; 0: for ever
};

ConsoleSettings settings_of(const RunRequest& request);
// Runs the script, stdin or the text of the request. Throws what Console::run_file throws.
void run(Console& console, const RunRequest& request);
// Returns the checkpoint that `resumed` names. Throws Error (files).
Found checkpoint_of(const RunRequest& request);

// Returns the exit code. Stdout gets the output of the script; with --json only the one object, and
// only if the script ended normally or was interrupted.
int command_run(const RunRequest& request);

// Returns the object of --json: the last simulation, with all of them under "simulations" if there
// are several; {"schema":1,"script":...,"simulations":[]} if there is none.
nlohmann::ordered_json json_of(const std::vector<Summary>& simulations, const std::string& script,
                               SummaryDetail detail = SummaryDetail::usual);

}  // namespace hackle
