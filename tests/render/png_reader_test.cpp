// SPDX-License-Identifier: MIT
// Every kind of PNG shows the same picture; other files are refused.
#include "render/png_reader.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr int side = 24;

// A dark disc on a light ground.
bool is_dark(int x, int y) {
  return (x - 11) * (x - 11) + (y - 9) * (y - 9) < 30;
}

struct Kind {
  const char* name;
  int depth;
  int colour;  // PNG_COLOR_TYPE_...
  Bytes dark;  // of one pixel; below 8 bits, its value
  Bytes light;
  int interlace = PNG_INTERLACE_NONE;
};
void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

Bytes row_of(const Kind& kind, int y) {
  Bytes row;
  for (int x = 0; x < side; ++x) {
    const Bytes& pixel = is_dark(x, y) ? kind.dark : kind.light;
    if (kind.depth >= 8) {
      row.insert(row.end(), pixel.begin(), pixel.end());
      continue;
    }
    const int per_byte = 8 / kind.depth, place = x % per_byte;
    if (place == 0) row.push_back(0);
    row.back() = static_cast<std::uint8_t>(row.back() | pixel[0] << (8 - kind.depth * (place + 1)));
  }
  return row;
}

fs::path written(const Kind& kind, const fs::path& folder) {
  const fs::path path = folder / "a.png";
  std::vector<Bytes> rows;
  std::vector<png_bytep> pointers;
  for (int y = 0; y < side; ++y) rows.push_back(row_of(kind, y));
  for (Bytes& row : rows) pointers.push_back(row.data());
  FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, side, side, kind.depth, kind.colour, kind.interlace,
               PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
  const png_color palette[] = {{0, 0, 0}, {255, 255, 255}};
  if (kind.colour == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_set_rows(png, info, pointers.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
  return path;
}

class EveryKind : public testing::TestWithParam<Kind> {};

TEST_P(EveryKind, ShowsTheSamePicture) {
  const test::Folder folder;
  const GreyImage image = read_png(written(GetParam(), folder.path));
  ASSERT_EQ(image.width, side);
  ASSERT_EQ(image.height, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      ASSERT_EQ(image.pixels[static_cast<std::size_t>(y * side + x)], is_dark(x, y) ? 0 : 255)
          << x << "," << y;
}

INSTANTIATE_TEST_SUITE_P(
    Png, EveryKind,
    testing::Values(
        Kind{"Grey", 8, PNG_COLOR_TYPE_GRAY, {0}, {255}},
        Kind{"GreyOf1Bit", 1, PNG_COLOR_TYPE_GRAY, {0}, {1}},
        Kind{"GreyOf4Bits", 4, PNG_COLOR_TYPE_GRAY, {0}, {15}},
        Kind{"GreyOf16Bits", 16, PNG_COLOR_TYPE_GRAY, {0, 0}, {255, 255}},
        Kind{"Palette", 8, PNG_COLOR_TYPE_PALETTE, {0}, {1}},
        Kind{"PaletteOf2Bits", 2, PNG_COLOR_TYPE_PALETTE, {0}, {1}},
        Kind{"Colour", 8, PNG_COLOR_TYPE_RGB, {0, 0, 0}, {255, 255, 255}},
        Kind{"ColourOf16Bits", 16, PNG_COLOR_TYPE_RGB, {0, 0, 0, 0, 0, 0}, Bytes(6, 255)},
        Kind{"GreyAndAlpha", 8, PNG_COLOR_TYPE_GRAY_ALPHA, {0, 255}, {255, 255}},
        Kind{"TransparentGround", 8, PNG_COLOR_TYPE_RGB_ALPHA, {0, 0, 0, 255}, {0, 0, 0, 0}},
        Kind{"Interlaced", 8, PNG_COLOR_TYPE_RGB, {0, 0, 0}, {255, 255, 255}, PNG_INTERLACE_ADAM7},
        Kind{"InterlacedOf1Bit", 1, PNG_COLOR_TYPE_GRAY, {0}, {1}, PNG_INTERLACE_ADAM7}),
    [](const auto& given) { return std::string(given.param.name); });

std::string refusal(const fs::path& path) {
  try {
    read_png(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "read";
}

// Truncated anywhere, or with any byte changed, a file is either a picture or refused.
TEST(PngReader, ADamagedFileIsRefused) {
  const test::Folder folder;
  const fs::path path = written({"", 8, PNG_COLOR_TYPE_GRAY, {0}, {255}}, folder.path);
  const std::string whole = read_text(path);
  for (std::size_t length = 0; length + 12 < whole.size(); length += 3) {
    write_text(path, whole.substr(0, length));
    EXPECT_THAT(refusal(path), testing::HasSubstr("cannot read the picture")) << length;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x55);
    write_text(path, changed);
    EXPECT_THAT(refusal(path), testing::AnyOf("read", testing::HasSubstr("picture"))) << at;
  }
}

TEST(PngReader, WhatIsNoPngIsRefused) {
  const test::Folder folder;
  write_text(folder.path / "a.png", "no picture");
  EXPECT_THAT(refusal(folder.path / "a.png"), testing::HasSubstr("damaged or no PNG"));
  EXPECT_THAT(refusal(folder.path / "b.png"), testing::HasSubstr("No such file"));
  EXPECT_THAT(refusal(folder.path), testing::HasSubstr("cannot read the picture"));
}

}  // namespace
}  // namespace hackle
