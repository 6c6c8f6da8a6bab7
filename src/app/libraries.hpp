// SPDX-License-Identifier: MIT
// The libraries the program was built with, or runs with if they tell their version.
#pragma once

#include <string>
#include <vector>

namespace hackle {

struct Library {
  std::string name;
  std::string version;
};

std::vector<Library> libraries();

// Returns "Lua 5.4.4, HDF5 1.10.8, ...".
std::string libraries_line();

}  // namespace hackle
