// SPDX-License-Identifier: MIT
// What the program says to a person, on stderr.
#pragma once

#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "output/summary.hpp"

namespace hackle {

// "error: ..." for each problem; in red on a terminal unless NO_COLOR is set.
void tell(const Error& error);

// "wrote out/a.mp4 (1.2 MB)" for each file of the simulations, each once.
void tell_files(const std::vector<Summary>& simulations);

// How much to say, as the terminal and the user want it.
Talk talk(bool quiet);

}  // namespace hackle
