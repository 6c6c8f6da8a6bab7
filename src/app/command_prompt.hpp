// SPDX-License-Identifier: MIT
// hackle without arguments: the prompt.
#pragma once

#include "app/company.hpp"
#include "app/limits.hpp"
#include "console/console.hpp"

namespace hackle {

// Asks on the terminal what to do with the console, as the prompt does. Returns the exit code, see
// command_prompt; `code` is that of what went before. Of several ranks, the first one asks, and all
// run what it was told.
int ask(Console& console, const Company& company, int code = 0);

// Reads lines from the terminal, or plainly from stdin if that is not a terminal. Returns the exit
// code: that of os.exit; otherwise, for plain lines, that of the first error.
int command_prompt(const Limits& limits);

}  // namespace hackle
