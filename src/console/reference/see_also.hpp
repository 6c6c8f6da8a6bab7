// SPDX-License-Identifier: MIT
// Which functions of the scene language belong together.
#pragma once

#include <string_view>
#include <vector>

namespace hackle {

// What a reader of this function may want to know next.
std::vector<std::string_view> see_also(std::string_view function);

}  // namespace hackle
