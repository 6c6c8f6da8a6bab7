// SPDX-License-Identifier: MIT
// Puts many pictures on one sheet, each with its title.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/image.hpp"
#include "render/theme.hpp"

namespace hackle {

struct SheetPicture {
  std::filesystem::path file;  // a PNG
  std::string title;           // may be empty
};

// A picture in memory with its title.
struct SheetImage {
  Image image;
  std::string title;
};

struct SheetLayout {
  int columns = 4;        // at least 1
  int width = 320;        // px, of each cell
  double font = 0.05;     // of the titles, in cell widths; at least 10 px
  double tallest = 0.75;  // height of a picture over its width; higher ones are scaled to it
  bool titled = true;     // leaves room for titles
  Look look = Look::dark;
  bool letters = false;  // "(a) ", "(b) ", ... before the titles
  bool even = false;     // makes width and height of the sheet even, for a movie
};

// The largest width and height of a sheet, px.
inline constexpr int max_of_sheet = 16384;

// Places pictures from left to right and from the top, each scaled to the width of its cell and at
// most `tallest` times as high as that, with its title below (shortened if too long). A row is as
// high as its highest picture. `legend` stands below all, if it has any height. Throws Error
// (refused) if there is no picture or the sheet would exceed max_of_sheet, Error (files) if a
// picture cannot be read.
Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout);
Image contact_sheet(std::vector<SheetImage>& images, const SheetLayout& layout,
                    const Image& legend = {});

// Returns the width of a sheet of so many pictures, px.
int sheet_width(int count, const SheetLayout& layout);

}  // namespace hackle
