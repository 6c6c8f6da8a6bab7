// SPDX-License-Identifier: MIT
// What help() shows a newcomer: a first plate in a few lines, and where to read on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hackle {

std::string tour();

// The lines of it that are typed, in order; they run.
std::vector<std::string_view> tour_lines();

}  // namespace hackle
