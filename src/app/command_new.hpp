// SPDX-License-Identifier: MIT
// hackle new NAME
#pragma once

#include <string>

namespace hackle {

// Writes a script to start from, NAME.lua, in the current folder; never replaces an existing file.
// Returns the exit code.
int command_new(const std::string& name);

}  // namespace hackle
