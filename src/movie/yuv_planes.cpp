// SPDX-License-Identifier: MIT
#include "movie/yuv_planes.hpp"

#include <algorithm>
#include <cstddef>

namespace hackle {
namespace {

// ITU-R BT.709: the shares of red and blue in luma; 219 levels from 16 on for luma, 112 levels to
// both sides of 128 for a colour difference.
constexpr double red_share = 0.2126, blue_share = 0.0722;
constexpr double green_share = 1.0 - red_share - blue_share;
constexpr double luma_range = 219.0 / 255.0, chroma_range = 112.0 / 255.0;
constexpr int fraction_bits = 16;

constexpr int fixed(double factor) {
  return static_cast<int>(factor * (1 << fraction_bits) + (factor < 0.0 ? -0.5 : 0.5));
}

struct Weights {
  int red, green, blue;
};

constexpr Weights luma{fixed(luma_range * red_share), fixed(luma_range* green_share),
                       fixed(luma_range* blue_share)};
constexpr Weights blueness{fixed(-chroma_range * red_share / (1.0 - blue_share)),
                           fixed(-chroma_range* green_share / (1.0 - blue_share)),
                           fixed(chroma_range)};
constexpr Weights redness{fixed(chroma_range),
                          fixed(-chroma_range* green_share / (1.0 - red_share)),
                          fixed(-chroma_range* blue_share / (1.0 - red_share))};

// For a sum of 2^`bits` pixels; written so that compilers vectorise it.
template <int bits>
inline std::uint8_t level(const Weights& weights, int zero, int red, int green, int blue) {
  constexpr int shift = fraction_bits + bits;
  const int sum = weights.red * red + weights.green * green + weights.blue * blue;
  return static_cast<std::uint8_t>((sum + (zero << shift) + (1 << (shift - 1))) >> shift);
}

void fill_luma(const std::uint8_t* __restrict pixels, std::uint8_t* __restrict row, int width) {
  for (int x = 0; x < width; ++x, pixels += 4)
    row[x] = level<0>(luma, 16, pixels[2], pixels[1], pixels[0]);
}

void fill_chroma(const std::uint8_t* __restrict upper, const std::uint8_t* __restrict lower,
                 std::uint8_t* __restrict blues, std::uint8_t* __restrict reds, int width) {
  for (int x = 0; x < width / 2; ++x, upper += 8, lower += 8) {
    const int blue = upper[0] + upper[4] + lower[0] + lower[4];
    const int green = upper[1] + upper[5] + lower[1] + lower[5];
    const int red = upper[2] + upper[6] + lower[2] + lower[6];
    blues[x] = level<2>(blueness, 128, red, green, blue);
    reds[x] = level<2>(redness, 128, red, green, blue);
  }
}

}  // namespace

void YuvPlanes::fill(const Image& image, const Planes& planes, const Strides& strides) {
  const bool first = pixels_.empty();
  if (first) pixels_ = image.pixels;
  const std::ptrdiff_t stride = image.stride();
  for (int y = 0; y < image.height; y += 2) {
    const std::uint8_t* upper = image.pixels.data() + y * stride;
    std::uint8_t* before = pixels_.data() + y * stride;
    if (!first && std::equal(upper, upper + 2 * stride, before)) continue;
    std::copy(upper, upper + 2 * stride, before);
    std::uint8_t* row = planes[0] + static_cast<std::ptrdiff_t>(y) * strides[0];
    fill_luma(upper, row, image.width);
    fill_luma(upper + stride, row + strides[0], image.width);
    fill_chroma(upper, upper + stride, planes[1] + static_cast<std::ptrdiff_t>(y / 2) * strides[1],
                planes[2] + static_cast<std::ptrdiff_t>(y / 2) * strides[2], image.width);
  }
}

}  // namespace hackle
