// SPDX-License-Identifier: MIT
// hackle(1) and the same in Markdown.
#pragma once

#include <string>
#include <vector>

#include "app/command_table.hpp"

namespace hackle {

// Returns the command line and a short scene language, in roff with the macros of man(7).
std::string man_page(const std::vector<Command>& commands);

// Returns the complete command line and scene language. Throws Error (files) if the library of
// materials cannot be read.
std::string markdown_page(const std::vector<Command>& commands);

}  // namespace hackle
