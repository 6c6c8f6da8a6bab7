// SPDX-License-Identifier: MIT
// hackle check FILE
#pragma once

#include <string>

#include "app/command_run.hpp"

namespace hackle {

// Says on stdout what every simulation of the script would take, without computing or writing
// anything. Returns the exit code: that of the first error a run of it would meet so far.
int command_check(const RunRequest& request);

// "Options of plate.lua, for --set:" and a line for each, or that there are none. The script is run
// until it declares them. Throws what Console::run_file throws.
std::string options_text(const RunRequest& request);

}  // namespace hackle
