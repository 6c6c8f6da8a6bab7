// SPDX-License-Identifier: MIT
#include "movie/yuv_planes.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "movie/pictures.hpp"

namespace hackle {
namespace {

using test::noise;
using test::plain;

constexpr int width = 38, height = 22, stride = 48;

// Planes with extra room at the end of each row, which must stay untouched.
struct Filled {
  std::array<std::vector<std::uint8_t>, 3> planes{
      std::vector<std::uint8_t>(stride * height, 99),
      std::vector<std::uint8_t>(stride* height / 2, 99),
      std::vector<std::uint8_t>(stride* height / 2, 99)};
  YuvPlanes yuv;

  void fill(const Image& image) {
    yuv.fill(image, {planes[0].data(), planes[1].data(), planes[2].data()},
             {stride, stride, stride});
  }
};

// Computes ITU-R BT.709-6, items 3.2 to 3.5, for red, green and blue from 0 to 255.
std::array<double, 3> bt709(double red, double green, double blue) {
  const double luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  return {16.0 + 219.0 / 255.0 * luma, 128.0 + 224.0 / 255.0 * (blue - luma) / 1.8556,
          128.0 + 224.0 / 255.0 * (red - luma) / 1.5748};
}

// Returns the mean of `size` by `size` pixels.
std::array<double, 3> mean_of(const Image& image, int left, int top, int size) {
  std::array<double, 3> sum{};
  for (int y = top; y < top + size; ++y)
    for (int x = left; x < left + size; ++x)
      for (int c = 0; c < 3; ++c)
        sum[static_cast<std::size_t>(2 - c)] +=
            image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x + c)];
  for (double& value : sum) value /= size * size;
  return sum;
}

void expect_right(const Image& image, const Filled& filled) {
  // Half a level from rounding, and 2^-16 from each weight.
  constexpr double off = 0.5 + 0.01;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [red, green, blue] = mean_of(image, x, y, 1);
      const auto at = static_cast<std::size_t>(y * stride + x);
      ASSERT_NEAR(filled.planes[0][at], bt709(red, green, blue)[0], off) << x << " " << y;
    }
  for (int y = 0; y < height / 2; ++y)
    for (int x = 0; x < width / 2; ++x) {
      const auto [red, green, blue] = mean_of(image, 2 * x, 2 * y, 2);
      const auto at = static_cast<std::size_t>(y * stride + x);
      ASSERT_NEAR(filled.planes[1][at], bt709(red, green, blue)[1], off) << x << " " << y;
      ASSERT_NEAR(filled.planes[2][at], bt709(red, green, blue)[2], off) << x << " " << y;
    }
}

TEST(YuvPlanes, AreThoseOfBt709) {
  Filled filled;
  filled.fill(noise(width, height, 1));
  expect_right(noise(width, height, 1), filled);
  for (int y = 0; y < height; ++y)
    EXPECT_EQ(filled.planes[0][static_cast<std::size_t>(y * stride + width)], 99);
}

TEST(YuvPlanes, ReachTheEndsOfTheirRange) {
  Filled filled;
  filled.fill(plain(width, height, 255, 255, 255));
  EXPECT_EQ(filled.planes[0][0], 235);
  filled.fill(plain(width, height, 0, 0, 0));
  EXPECT_EQ(filled.planes[0][0], 16);
  EXPECT_EQ(filled.planes[1][0], 128);
  filled.fill(plain(width, height, 255, 0, 0));
  EXPECT_EQ(filled.planes[2][0], 240);
  filled.fill(plain(width, height, 255, 255, 0));
  EXPECT_EQ(filled.planes[1][0], 16);
}

TEST(YuvPlanes, FollowWhateverRowChanges) {
  Filled filled;
  Image image = noise(width, height, 2);
  filled.fill(image);
  for (const int row : {0, 7, 12, height - 1}) {
    for (int x = 0; x < width; x += 3)
      image.pixels[static_cast<std::size_t>(row * image.stride() + 4 * x)] ^= 0x80;
    filled.fill(image);
    expect_right(image, filled);
  }
  filled.fill(image);
  expect_right(image, filled);
}

}  // namespace
}  // namespace hackle
