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
  std::vector<std::string> words;  // run files, the file to write, key=value
  Execution execution;
  bool quiet = false;
};

// The parsed words.
struct RenderJob {
  std::vector<std::string> runs;                             // at least one
  std::string out;                                           // "" to describe the records
  std::vector<std::pair<std::string, std::string>> options;  // as given
};

// Words with "=" that name no file are options; the last of the others is the output, unless it
// ends in .h5. Throws Error (usage).
RenderJob render_job(const std::vector<std::string>& words);

// Returns the job as a script that calls r:frame, r:movie, contact_sheet or side_by_side. The value
// of an option is a Lua expression, except where the function takes a text or one of several names:
// it is then taken literally. Throws Error (refused) for a name that the function does not know.
std::string script_of(const RenderJob& job);

// Makes a picture, a movie or a sheet of records, or describes the records on stdout. Returns the
// exit code.
int command_render(const RenderRequest& request);

}  // namespace hackle
