// SPDX-License-Identifier: MIT
// Related functions of the scene language.
#pragma once

#include <string_view>
#include <vector>

namespace hackle {

// Returns the functions that a reader of this one may need next.
std::vector<std::string_view> see_also(std::string_view function);

}  // namespace hackle
