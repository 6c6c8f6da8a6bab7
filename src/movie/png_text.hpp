// SPDX-License-Identifier: MIT
// Texts in a PNG, animated or not.
#pragma once

#include <string>
#include <string_view>

#include "movie/byte_file.hpp"

namespace hackle {

// Returns a chunk "iTXt" (PNG 11.3.4.5), which may stand between any two others; the text is UTF-8.
Bytes png_text(std::string_view keyword, std::string_view text);

// Returns the text of such a chunk in a PNG, or "".
std::string text_in_png(std::string_view png, std::string_view keyword);

}  // namespace hackle
