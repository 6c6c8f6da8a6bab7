// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hackle {

// Brightness from 0 (black) to 255 (white), as a screen shows it (sRGB).
struct GreyImage {
  int width = 0;                     // px
  int height = 0;                    // px
  std::vector<std::uint8_t> pixels;  // row by row from the top
};

inline constexpr std::int64_t max_pixels = std::int64_t{1} << 24;

// Reads a PNG of any kind: grey, colour or palette, 1 to 16 bits, interlaced or not. Transparent
// pixels are laid on white. Throws Error (files) if it cannot be read, Error (refused) if it has
// more than max_pixels.
GreyImage read_png(const std::filesystem::path& path);

// In px.
struct PictureSize {
  int width = 0, height = 0;
};

// Returns the size of a PNG without reading its pixels. Throws what read_png() throws for a file
// that is none or is too large.
PictureSize size_of_png(const std::filesystem::path& path);

}  // namespace hackle
