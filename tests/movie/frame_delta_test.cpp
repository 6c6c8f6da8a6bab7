// SPDX-License-Identifier: MIT
// What changes from a picture to the next.
#include "movie/frame_delta.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "movie/pictures.hpp"

namespace hackle {
namespace {

using test::moving;
using test::noise;

constexpr int wide = 202, high = 50;  // more pixels in a row than one code can count

// Every way in which pixels can follow one another: near colours, far ones, runs, transparency.
Image waves(int frame) {
  Image image(wide, high);
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      auto* pixel = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
      pixel[0] = static_cast<std::uint8_t>(2 * x + 3 * frame);
      pixel[1] = static_cast<std::uint8_t>(x * (y / 7 % 8) + frame * (x / 60));
      pixel[2] = static_cast<std::uint8_t>(x / (y / 5 + 1));
      pixel[3] = static_cast<std::uint8_t>(y % 9 == 0 ? x : 255);
    }
  return image;
}

void expect_round_trip(const std::vector<Image>& pictures) {
  Image written(wide, high), read(wide, high);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const Bytes delta = advance_by_delta(written, pictures[k]);
    EXPECT_EQ(written.pixels, pictures[k].pixels) << k;
    EXPECT_TRUE(apply_delta(delta.all(), read)) << k;
    EXPECT_EQ(read.pixels, pictures[k].pixels) << k;
  }
}

TEST(FrameDelta, GivesEveryPixelBack) {
  const Image blank(wide, high);
  expect_round_trip({moving(wide, high, 0), moving(wide, high, 1), moving(wide, high, 1), blank,
                     moving(wide, high, 7)});
  expect_round_trip({waves(0), waves(1), waves(2), waves(40), blank, waves(41)});
  expect_round_trip({noise(wide, high, 1), noise(wide, high, 2), noise(wide, high, 3, true)});
}

TEST(FrameDelta, TakesFewBytesWhereLittleChanges) {
  Image picture(wide, high);
  const std::size_t first = advance_by_delta(picture, moving(wide, high, 0)).size();
  EXPECT_LT(first, 300U);  // of 40 400: two rows that differ, the rest repeats them
  EXPECT_EQ(advance_by_delta(picture, moving(wide, high, 0)).size(), 2U);
  EXPECT_LT(advance_by_delta(picture, moving(wide, high, 1)).size(), 600U);  // 30 rows
  // Random pixels are the worst: five bytes for four.
  const std::size_t worst = advance_by_delta(picture, noise(wide, high, 1)).size();
  EXPECT_LE(worst, 5U * wide * high + 2U * high);
}

TEST(FrameDelta, BytesThatAreNoneAreRefusedAndStayInThePicture) {
  Image before(wide, high), now = before;
  const Bytes delta = advance_by_delta(now, waves(1));
  for (std::size_t size = 0; size < delta.size(); size += 11) {
    Image picture = before;
    EXPECT_FALSE(apply_delta(delta.all().first(size), picture)) << size;
  }
  Image picture = before;
  std::vector<std::uint8_t> longer(delta.all().begin(), delta.all().end());
  longer.push_back(0);
  EXPECT_FALSE(apply_delta(longer, picture));
  EXPECT_FALSE(apply_delta(std::vector<std::uint8_t>{0x00, 0x40}, picture));  // above the first row
  EXPECT_FALSE(apply_delta(std::vector<std::uint8_t>{0x31, 0xc0}, picture));  // no kind of rows
  EXPECT_FALSE(apply_delta(std::vector<std::uint8_t>{0x32, 0x00}, picture));  // a row too many
  std::mt19937 random(1);
  for (int k = 0; k < 2000; ++k) {
    std::vector<std::uint8_t> bytes(delta.all().begin(), delta.all().end());
    for (int n = 0; n < 3; ++n)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    apply_delta(bytes, picture);  // whatever it shows: sanitizers watch
    ASSERT_EQ(picture.pixels.size(), before.pixels.size());
  }
}

}  // namespace
}  // namespace hackle
