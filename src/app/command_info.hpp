// SPDX-License-Identifier: MIT
// hackle info [FILE]
#pragma once

#include <filesystem>

namespace hackle {

struct InfoRequest {
  std::filesystem::path file;  // "" for the program and its machine
  bool json = false;
};

// Prints what a file of Hackle is (file_facts.hpp); without one, version, libraries and the
// resources of the machine. Returns the exit code.
int command_info(const InfoRequest& request);

}  // namespace hackle
