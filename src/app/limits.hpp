// SPDX-License-Identifier: MIT
// Limits on what a script may do to this machine, from the command line.
#pragma once

#include "console/session.hpp"

namespace hackle {

struct Limits {
  bool trust = false;
  int lua_memory = 1024;  // MB
  double output = 20.0;   // GB

  void apply(ConsoleSettings& settings) const {
    settings.trust = trust;
    settings.lua_memory = static_cast<std::size_t>(lua_memory) << 20U;
    settings.output_limit = 1e9 * output;
  }
};

}  // namespace hackle
