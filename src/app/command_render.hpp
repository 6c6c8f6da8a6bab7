// SPDX-License-Identifier: MIT
// hackle render RUN.h5 ... OUT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

struct RenderRequest {
  std::vector<std::string> words;  // run files, the file to be written, key=value
  Execution execution;
  bool quiet = false;
};

// What the words mean.
struct RenderJob {
  std::vector<std::string> runs;                             // at least one
  std::string out;                                           // "" to say what is recorded
  std::vector<std::pair<std::string, std::string>> options;  // as given
};

// Words with "=" that name no file are options; of the others the last is what is to be written,
// unless it ends in .h5. Throws Error (usage).
RenderJob render_job(const std::vector<std::string>& words);

// The same as a script, for r:frame, r:movie, contact_sheet or side_by_side. The value of an option
// is an expression of Lua; where its function takes a text or one of several names, it is that.
// Throws Error (refused) for a name that the function does not know.
std::string script_of(const RenderJob& job);

// Makes a picture, a movie or a sheet of what was recorded, or says on stdout what is there.
// Returns the exit code.
int command_render(const RenderRequest& request);

}  // namespace hackle
