// SPDX-License-Identifier: MIT
// Scripts with which a shell completes the command line.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/command_table.hpp"

namespace hackle {

inline constexpr std::array<std::string_view, 3> shell_names{"bash", "zsh", "fish"};

// Returns the script for one of shell_names.
std::string shell_completion(const std::vector<Command>& commands, std::string_view shell);

}  // namespace hackle
