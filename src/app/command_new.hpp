// SPDX-License-Identifier: MIT
// hackle new NAME
#pragma once

#include <string>

namespace hackle {

// Writes a script to begin with, NAME.lua, here; never over a file that is there. Returns the exit
// code.
int command_new(const std::string& name);

}  // namespace hackle
