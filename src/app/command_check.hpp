// SPDX-License-Identifier: MIT
// hackle check FILE
#pragma once

#include <string>

#include "app/command_run.hpp"

namespace hackle {

// Prints to stdout the cost of every simulation of the script, without computing or writing
// anything. Returns the exit code: that of the first error that a run of the script would meet so
// far.
int command_check(const RunRequest& request);

// Returns "Options of plate.lua, for --set:" and one line per option, or that there are none. Runs
// the script until it declares them. Throws what Console::run_file throws.
std::string options_text(const RunRequest& request);

}  // namespace hackle
