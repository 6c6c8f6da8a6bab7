// SPDX-License-Identifier: MIT
// hackle without arguments: the prompt.
#pragma once

#include "app/limits.hpp"

namespace hackle {

// Reads lines from the terminal, or plainly from stdin if that is not a terminal. Returns the exit
// code: that of os.exit; otherwise, for plain lines, that of the first error.
int command_prompt(const Limits& limits);

}  // namespace hackle
