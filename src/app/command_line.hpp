// SPDX-License-Identifier: MIT
// Parses the command line and runs its command.
#pragma once

#include <string>
#include <vector>

namespace hackle {

// Runs the whole program with the words after its name. Returns the exit code.
int run_program(std::vector<std::string> words);

// Puts the word `run` in front if no command is named and a script is: "hackle [options] FILE.lua"
// means "hackle run [options] FILE.lua". `words` must end before "--".
std::vector<std::string> with_command(std::vector<std::string> words);

}  // namespace hackle
