// SPDX-License-Identifier: MIT
// What the program says to a person, on stderr.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "output/summary.hpp"

namespace hackle {

// "error: what (remedy)" for each problem, every line with its "error:". In colour "error:" is red,
// what is wrong bold and the remedy faint.
std::string error_text(const Error& error, bool colour);

// The same on stderr, in colour on a terminal unless NO_COLOR is set.
void tell(const Error& error);

// "wrote a.png (16.3 kB)" on stderr.
void tell_file(const std::filesystem::path& file);

// "wrote out/a.mp4 (1.2 MB)" for each file of the simulations, each once, and what can be done with
// a recording.
void tell_files(const std::vector<Summary>& simulations);

// How much to say, as the terminal and the user want it.
Talk talk(bool quiet);

}  // namespace hackle
