// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "console/scripts.hpp"
#include "render/png_reader.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Returns the picture that s:frame makes with these options.
GreyImage frame(const std::string& options) {
  const test::Folder folder;
  const std::string message = test::message_of(
      test::scene + "s:frame { 'a.png', width = 400, " + options + " }", test::quiet(folder.path));
  EXPECT_EQ(message, "") << options;
  return read_png(folder.path / "a.png");
}

int different(const GreyImage& one, const GreyImage& other) {
  EXPECT_EQ(one.pixels.size(), other.pixels.size());
  int count = 0;
  for (std::size_t k = 0; k < std::min(one.pixels.size(), other.pixels.size()); ++k)
    count += one.pixels[k] != other.pixels[k] ? 1 : 0;
  return count;
}

TEST(OverlayOptions, ReachThePicture) {
  const GreyImage plain = frame("");
  EXPECT_EQ(different(frame("title = 'Duran 50 glass', clock = true, bar = true"), plain), 0);
  for (const char* options : {"title = ''", "title = 'Glass'", "clock = false", "bar = false",
                              "scale_bar = false", "markers = { {50*mm, 20*mm, 'tip'} }"})
    EXPECT_GT(different(frame(options), plain), 0) << options;
  EXPECT_GT(frame("load_curve = true").height, plain.height);
  EXPECT_LT(frame("title = '', clock = false").height, plain.height);
}

TEST(OverlayOptions, AMovieShowsTheEnergySoFarAndAPictureCannot) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    s:movie { 'a.mp4', every = 1*us, width = 320, energy = true, load_curve = true }
    s:run(3*us))",
                             test::quiet(folder.path)),
            "");
  for (const char* call : {"s:frame { 'a.png', energy = true }", "show(s, { energy = true })"})
    EXPECT_THAT(test::message_of(test::scene + call, test::quiet(folder.path)),
                HasSubstr("energy shows what was so far"));
}

TEST(OverlayOptions, MarkersSayWhichOneIsWrong) {
  EXPECT_THAT(
      test::message_of(test::scene + "s:frame { 'a.png', markers = { {0, 0, 'a'}, {0, 'b'} } }"),
      HasSubstr("frame: entry 2 of markers is not {x, y, \"label\"}"));
  EXPECT_THAT(test::message_of(test::scene + "s:frame { 'a.png', markers = {} }"),
              HasSubstr("markers is not a list of 1 or more"));
}

}  // namespace
}  // namespace hackle
