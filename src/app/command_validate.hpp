// SPDX-License-Identifier: MIT
// hackle validate [NAME...]
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/moving_plate.hpp"

namespace hackle {

struct ValidateRequest {
  std::vector<std::string> names;                 // of scripts, or files; none: all
  std::filesystem::path folder = "out/validate";  // of the page and of what the scripts write
  std::vector<std::filesystem::path> tables;      // Markdown files whose tables are rewritten
  Execution execution;
  bool quick = false;
  bool json = false;
  bool quiet = false;
};

// Returns the exit code: 0 if no check fails, 1 if one does.
int command_validate(const ValidateRequest& request);

}  // namespace hackle
