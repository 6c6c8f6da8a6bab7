// SPDX-License-Identifier: MIT
// What help() tells of the ready specimens: Lua modules that come with the program.
#pragma once

#include <cstddef>
#include <string>

namespace hackle {

// Lists the modules in Hackle's scripts/specimens, each with the first line of its header, and
// tells how to load one, for a terminal of `width` columns. Tells only where they should be if they
// are not installed.
std::string list_of_specimens(std::size_t width);

}  // namespace hackle
