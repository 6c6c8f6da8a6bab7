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

// The same with a picture in memory.
struct SheetImage {
  Image image;
  std::string title;
};

struct SheetLayout {
  int columns = 4;     // at least 1
  int width = 320;     // px, of each cell
  int height = 0;      // px, of each cell; 0: 3/4 of its width
  double font = 0.05;  // of the titles, in widths of a cell; at least 10 px
  bool titled = true;  // there is room for titles
  bool even = false;   // width and height of the sheet are, for a movie
};

// The largest width and height of a sheet, px.
inline constexpr int max_of_sheet = 16384;

// Pictures from left to right and from the top, each shrunk or grown to fit its cell, its title
// below it (shortened where it does not fit). Throws Error (refused) when there is none or the
// sheet would be larger than max_of_sheet, Error (files) when one cannot be read.
Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout);
Image contact_sheet(std::vector<SheetImage>& images, const SheetLayout& layout);

}  // namespace hackle
