// SPDX-License-Identifier: MIT
// hackle info
#pragma once

namespace hackle {

// Prints what was built, with which libraries, and what the machine offers. Returns the exit code.
int command_info(bool json);

}  // namespace hackle
