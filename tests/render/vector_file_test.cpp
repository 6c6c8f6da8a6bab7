// SPDX-License-Identifier: MIT
#include "render/vector_file.hpp"

#include <string>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "render/plate_painter.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::Not;

int times(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

PictureStyle small() {
  PictureStyle style;
  style.grid = {16, 8, 1e-3, {8e-3, 4e-3}};
  style.width = 600;
  style.title = "Duran";
  return style;
}

// Returns the content of a file of the picture.
std::string written(const PictureStyle& style, const char* name) {
  const test::Folder folder;
  Shot shot;
  shot.values.assign(style.grid.nodes(), 0.25F);
  PlatePainter(style).write_vectors(shot, folder.path / name);
  EXPECT_FALSE(std::filesystem::exists(partial_name(folder.path / name)));
  return read_text(folder.path / name);
}

TEST(VectorFile, IsKnownByItsEnding) {
  EXPECT_TRUE(is_vector_file("a/b.pdf") && is_vector_file("B.SVG"));
  EXPECT_FALSE(is_vector_file("a.png") || is_vector_file("pdf") || is_vector_file("a.pdf.png"));
}

// 600 px at 300 per inch are two inches of 72 points.
TEST(VectorFile, HasTheSizeOfItsPaper) {
  PictureStyle style = small();
  EXPECT_THAT(written(style, "a.pdf"), HasSubstr("/MediaBox [ 0 0 144 "));
  EXPECT_THAT(written(style, "a.svg"), HasSubstr("width=\"144pt\""));
  style.dpi = 150.0;
  EXPECT_THAT(written(style, "a.pdf"), HasSubstr("/MediaBox [ 0 0 288 "));
}

// The plate is the only image; the letters are those of an embedded font, or outlines.
TEST(VectorFile, HoldsThePlateAsAnImageAndTheRestAsVectors) {
  PictureStyle style = small();
  const std::string pdf = written(style, "a.pdf"), svg = written(style, "a.svg");
  EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
  EXPECT_EQ(times(pdf, "/Subtype /Image"), 1);
  EXPECT_THAT(pdf, HasSubstr("DejaVuSans"));
  EXPECT_EQ(times(svg, "<image "), 1);
  EXPECT_GT(times(svg, "<symbol "), 10) << "letters";
  style.second = FieldStyle{};
  style.arrangement = Arrangement::beside;
  const test::Folder folder;
  Shot shot;
  shot.values.assign(style.grid.nodes(), 0.25F);
  shot.second = shot.values;
  PlatePainter(style).write_vectors(shot, folder.path / "two.pdf");
  EXPECT_EQ(times(read_text(folder.path / "two.pdf"), "/Subtype /Image"), 2);
}

// The names in an SVG count the surfaces of the process, so only those of its first one are the
// same.
TEST(VectorFile, DoesNotSayWhenItWasMade) {
  const std::string pdf = written(small(), "a.pdf");
  EXPECT_TRUE(written(small(), "a.pdf") == pdf);
  EXPECT_THAT(pdf, Not(HasSubstr("CreationDate")));
}

TEST(VectorFile, ThatCannotBeWrittenIsRefused) {
  EXPECT_THROW(write_vectors("/proc/none/a.pdf", {100, 100, 300.0}, [](Canvas&) {}), Error);
}

}  // namespace
}  // namespace hackle
