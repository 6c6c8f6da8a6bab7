// SPDX-License-Identifier: MIT
#include "render/contact_sheet.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "render/png.hpp"
#include "render/theme.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

std::filesystem::path white_png(const std::filesystem::path& folder, int width, int height) {
  Image image(width, height);
  std::ranges::fill(image.pixels, std::uint8_t{255});
  write_png(image, folder / "white.png");
  return folder / "white.png";
}

int red_at(const Image& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x + 2)];
}

// Counts the bright pixels of a row; the rim of a scaled picture may spread by half a pixel.
int painted(const Image& image, int y) {
  int count = 0;
  for (int x = 0; x < image.width; ++x) count += red_at(image, x, y) > 128 ? 1 : 0;
  return count;
}

// Cells of 100 x 75 px with gaps of 4 and a line of 2.2 times 10 px and half a gap below each.
TEST(ContactSheet, LaysPicturesOutInColumns) {
  const test::Folder folder;
  const auto file = white_png(folder.path, 200, 150);
  const Image sheet = contact_sheet({{file, ""}, {file, ""}, {file, ""}}, {2, 100});
  EXPECT_EQ(sheet.width, 2 * 104 + 4);
  EXPECT_EQ(sheet.height, 2 * 99 + 4);
  EXPECT_EQ(painted(sheet, 4 + 37), 200);
  EXPECT_EQ(painted(sheet, 4 + 99 + 37), 100);
  EXPECT_EQ(painted(sheet, 4 + 75 + 10), 0);
}

TEST(ContactSheet, ARowIsAsHighAsItsHighestPicture) {
  const test::Folder folder;
  const auto flat = white_png(folder.path, 400, 100);
  const Image sheet = contact_sheet({{flat, ""}}, {4, 100});
  EXPECT_EQ(sheet.height, 4 + 25 + 22 + 2 + 0);
  EXPECT_EQ(painted(sheet, 4 + 12), 100);
  std::filesystem::rename(flat, folder.path / "flat.png");
  const auto high = white_png(folder.path, 100, 50);
  const Image both = contact_sheet({{folder.path / "flat.png", ""}, {high, ""}}, {2, 100});
  EXPECT_EQ(both.height, 4 + 50 + 22 + 2);
  EXPECT_EQ(painted(both, 4 + 2), 100) << "only the higher one";
  EXPECT_EQ(painted(both, 4 + 25), 200) << "the flat one lies in the middle";
}

TEST(ContactSheet, LettersStandBeforeTheTitles) {
  const test::Folder folder;
  const auto file = white_png(folder.path, 400, 100);
  SheetLayout layout{2, 100};
  layout.titled = false;
  const int without = contact_sheet({{file, ""}, {file, ""}}, layout).height;
  layout.letters = true;
  const Image sheet = contact_sheet({{file, ""}, {file, ""}}, layout);
  EXPECT_GT(sheet.height, without);
  int left = 0, right = 0;
  for (int y = 4 + 25 + 1; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x)
      if (red_at(sheet, x, y) != background_colour.red) ++(x < 4 + 100 + 2 ? left : right);
  EXPECT_GT(left, 10);
  EXPECT_GT(right, 10);
}

TEST(ContactSheet, HasTheGroundOfItsLookAndItsLegend) {
  const test::Folder folder;
  SheetLayout layout{1, 100};
  layout.look = Look::light;
  std::vector<SheetImage> images{{Image(100, 50), ""}};
  const int plain = contact_sheet(images, layout).height;
  Image legend(104, 9);
  std::ranges::fill(legend.pixels, std::uint8_t{255});
  for (std::size_t k = 2; k < legend.pixels.size(); k += 4) legend.pixels[k] = 77;
  const Image sheet = contact_sheet(images, layout, legend);
  EXPECT_EQ(sheet.height, plain + 9);
  EXPECT_EQ(red_at(sheet, 1, 1), 255);
  EXPECT_EQ(red_at(sheet, 50, sheet.height - 5), 77);
}

TEST(ContactSheet, TitlesStandBelowAndStayInTheirCell) {
  const test::Folder folder;
  const auto file = white_png(folder.path, 40, 30);
  const Image sheet = contact_sheet({{file, std::string(200, 'M')}, {file, ""}}, {2, 100});
  int left = 0, right = 0;
  for (int y = 4 + 75 + 1; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x)
      if (red_at(sheet, x, y) != background_colour.red) ++(x < 4 + 100 + 2 ? left : right);
  EXPECT_GT(left, 100);
  EXPECT_EQ(right, 0);
}

TEST(ContactSheet, RefusesWhatItCannotDraw) {
  const test::Folder folder;
  EXPECT_THROW(contact_sheet({}, {}), Error);
  EXPECT_THROW(contact_sheet({{folder.path / "no.png", ""}}, {}), Error);
  std::ofstream(folder.path / "text.png") << "this is no picture";
  EXPECT_THROW(contact_sheet({{folder.path / "text.png", ""}}, {}), Error);
  const auto file = white_png(folder.path, 4, 3);
  try {
    contact_sheet({{file, ""}, {file, ""}, {file, ""}, {file, ""}, {file, ""}}, {5, 4096});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("more than 16384"));
  }
}

}  // namespace
}  // namespace hackle
