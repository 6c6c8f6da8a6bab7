// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace hackle {

// Returns whether the text is well-formed UTF-8: no stray or overlong bytes, no surrogates.
bool is_utf8(std::string_view text);

}  // namespace hackle
