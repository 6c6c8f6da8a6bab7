// SPDX-License-Identifier: MIT
// hackle diff A B
#pragma once

#include <filesystem>

namespace hackle {

struct DiffRequest {
  std::filesystem::path one, other;  // run files or checkpoints
  bool json = false;
  bool quiet = false;
};

// Prints in what two runs differ. Returns 0 if in nothing, 1 if in something, or the exit code of
// an error.
int command_diff(const DiffRequest& request);

}  // namespace hackle
