// SPDX-License-Identifier: MIT
// Pictures as most encoders want them: BT.709, limited range, colour at half the resolution.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.hpp"

namespace hackle {

// Brightness of every pixel, and two colour differences of the mean of every two by two, each a
// plane of bytes with so many of them a row. Rounded to the nearest level.
class YuvPlanes {
 public:
  using Planes = std::array<std::uint8_t*, 3>;
  using Strides = std::array<int, 3>;

  // Fills the planes, which hold what the last call left there: rows that are the same as in the
  // image before, nine of ten when a crack runs, are not computed again. All images are of one
  // size, even both ways.
  void fill(const Image& image, const Planes& planes, const Strides& strides);

 private:
  std::vector<std::uint8_t> pixels_;  // of the image before
};

}  // namespace hackle
