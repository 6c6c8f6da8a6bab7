// SPDX-License-Identifier: MIT
// The tour by help() for a newcomer: a first plate in a few lines, and where to read on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hackle {

std::string tour();

// Returns the typed lines of the tour, in order; they run.
std::vector<std::string_view> tour_lines();

}  // namespace hackle
