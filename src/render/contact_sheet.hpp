// SPDX-License-Identifier: MIT
// Many pictures on one, each with its title.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/image.hpp"

namespace hackle {

struct SheetPicture {
  std::filesystem::path file;  // a PNG
  std::string title;           // may be empty
};

struct SheetLayout {
  int columns = 4;  // at least 1
  int width = 320;  // px, of each cell; a cell is 3/4 as high
};

// The largest width and height of a sheet, px.
inline constexpr int most_of_sheet = 16384;

// Pictures from left to right and from the top, each shrunk or grown to fit its cell, its title
// below it (shortened where it does not fit). Throws Error (refused) when there is none or the
// sheet would be larger than most_of_sheet, Error (files) when one cannot be read.
Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout);

}  // namespace hackle
