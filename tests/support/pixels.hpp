// SPDX-License-Identifier: MIT
// Counts pixels of pictures.
#pragma once

#include <algorithm>

#include "base/image.hpp"
#include "render/colour_map.hpp"
#include "render/overlay/rectangle.hpp"

namespace hackle::test {

inline const std::uint8_t* pixel(const Image& image, int x, int y) {
  return &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
}

template <class Is>
int count_pixels(const Image& image, const Rectangle& area, Is is) {
  int count = 0;
  for (int y = std::max(0, area.y); y < std::min(image.height, area.bottom()); ++y)
    for (int x = std::max(0, area.x); x < std::min(image.width, area.right()); ++x)
      count += is(x, y) ? 1 : 0;
  return count;
}

// Counts pixels in a rectangle that are not black.
inline int lit(const Image& image, const Rectangle& area) {
  return count_pixels(image, area, [&](int x, int y) {
    const auto* at = pixel(image, x, y);
    return at[0] + at[1] + at[2] > 0;
  });
}

// Counts pixels in a rectangle that have another colour.
inline int differing(const Image& image, const Rectangle& area, Colour colour) {
  return count_pixels(image, area, [&](int x, int y) {
    const auto* at = pixel(image, x, y);
    return !(Colour{at[2], at[1], at[0]} == colour);
  });
}

// Counts pixels outside a rectangle that differ between two pictures of the same size.
inline int differing_outside(const Image& one, const Image& other, const Rectangle& area) {
  return count_pixels(one, {0, 0, one.width, one.height}, [&](int x, int y) {
    const bool inside = x >= area.x && x < area.right() && y >= area.y && y < area.bottom();
    return !inside && !std::equal(pixel(one, x, y), pixel(one, x, y) + 4, pixel(other, x, y));
  });
}

}  // namespace hackle::test
