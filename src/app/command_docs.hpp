// SPDX-License-Identifier: MIT
// hackle docs
#pragma once

#include <string>
#include <vector>

#include "app/command_table.hpp"

namespace hackle {

struct DocsRequest {
  bool man = false;
  bool markdown = false;   // the default
  std::string completion;  // "" or a shell
};

// Writes one of the forms to stdout. Returns the exit code.
int command_docs(const DocsRequest& request, const std::vector<Command>& commands);

}  // namespace hackle
