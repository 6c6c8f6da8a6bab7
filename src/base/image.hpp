// SPDX-License-Identifier: MIT
// A picture in memory, shared by painter, overlay, PNG writer and encoder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hackle {

// Rows from the top, four bytes per pixel in the order blue, green, red, alpha (which OSMesa, Cairo
// and FFmpeg read without a copy). Alpha is premultiplied.
struct Image {
  int width = 0;   // px
  int height = 0;  // px
  std::vector<std::uint8_t> pixels;

  Image() = default;
  Image(int w, int h)
      : width(w),
        height(h),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4) {}

  int stride() const { return width * 4; }  // bytes per row
};

}  // namespace hackle
