// SPDX-License-Identifier: MIT
// hackle chart RUN.h5 ... WHAT ... OUT
#pragma once

#include <string>
#include <vector>

#include "app/word_options.hpp"

namespace hackle {

struct ChartRequest {
  std::vector<std::string>
      words;  // run files and tables, what to draw, the file to write, key=value
  bool quiet = false;
};

// The parsed words.
struct ChartJob {
  std::vector<std::string> sources;  // at least one
  std::vector<std::string> what;     // kinds of chart, or columns; empty to list them
  std::string out;
  WordOptions options;
};

// A word with "=" that names no file is an option; of the others those that end in .h5, .hdf5 or
// .csv are sources, those that end as pictures do the output, which is by default named after the
// first source and what is drawn. Throws Error (usage).
ChartJob chart_job(const std::vector<std::string>& words);

// Draws a chart, or lists what can be drawn of the files on stdout. Returns the exit code.
int command_chart(const ChartRequest& request);

}  // namespace hackle
