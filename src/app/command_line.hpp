// SPDX-License-Identifier: MIT
// What the words of the command line ask for.
#pragma once

#include <string>
#include <vector>

namespace hackle {

// The whole program, given the words after its name. Returns the exit code.
int run_program(std::vector<std::string> words);

// "hackle [options] FILE.lua" means "hackle run [options] FILE.lua": puts the word `run` in front
// when no command is named and a script is. `words` end before "--".
std::vector<std::string> with_command(std::vector<std::string> words);

}  // namespace hackle
