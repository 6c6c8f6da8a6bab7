// SPDX-License-Identifier: MIT
// Pictures in the form most encoders need: BT.709, limited range, colour at half resolution.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.hpp"

namespace hackle {

// The luma of every pixel, and two colour differences of the mean of every two by two pixels, each
// as a plane of bytes with its own row length. Rounded to the nearest level.
class YuvPlanes {
 public:
  using Planes = std::array<std::uint8_t*, 3>;
  using Strides = std::array<int, 3>;

  // Fills the planes, which keep the result of the last call: rows equal to those of the previous
  // image, nine of ten while a crack runs, are not computed again. All images have one size, even
  // in both directions.
  void fill(const Image& image, const Planes& planes, const Strides& strides);

 private:
  std::vector<std::uint8_t> pixels_;  // of the previous image
};

}  // namespace hackle
