// SPDX-License-Identifier: MIT
// hackle, alone: the prompt.
#pragma once

#include "app/limits.hpp"

namespace hackle {

// Reads lines from the terminal, or plainly from stdin when it is none. Returns the exit code:
// that of os.exit; else, for plain lines, that of the first error.
int command_prompt(const Limits& limits);

}  // namespace hackle
