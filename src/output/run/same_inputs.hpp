// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hackle {

// Throws Error (refused), naming the members that differ, unless both are the same inputs of a run
// (store/inputs.hpp). Functions count as equal.
void check_same_inputs(const std::string& present, const std::string& former);

}  // namespace hackle
