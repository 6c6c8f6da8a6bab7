// SPDX-License-Identifier: MIT
// The version and build of this program.
#pragma once

#include <string_view>

namespace hackle {

std::string_view version();  // "0.1.0"
std::string_view
git_hash();  // short hash of the commit, "-dirty" if the tree differed, or "unknown"
std::string_view compiler();  // "GNU 12.2.0"

}  // namespace hackle
