// SPDX-License-Identifier: MIT
// Decodes movies and compares them with the input.
#include "movie/encoder.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/pictures.hpp"
#include "movie/player.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::format;
using test::fresh_folder;
using test::moving;
using test::plain;
using test::play;
using test::Played;

TEST(Encoder, EveryFrameIsThereAtItsTime) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(160, 90, 25.0));
  for (int k = 0; k < 70; ++k) encoder.add(moving(160, 90, k));
  EXPECT_EQ(encoder.frames(), 70);
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.times.size(), 70U);
  for (std::size_t k = 0; k < 70; ++k)
    EXPECT_NEAR(played.times[k], static_cast<double>(k) / 25.0, 1e-4);
  EXPECT_GT(encoder.seconds(), 0.0);
}

// Returns where the square of moving() begins in a row that crosses it.
int left_end_of_square(const Image& image) {
  int x = 0;
  while (image.pixels[static_cast<std::size_t>(25 * image.stride() + 4 * x)] < 145) ++x;
  return x;
}

TEST(Encoder, FramesAreShownInTheOrderTheyWereGiven) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(160, 90));
  for (int k = 0; k < 70; ++k) encoder.add(moving(160, 90, k));
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.frames.size(), 70U);
  // The edge of the square is sharp: the mean of its colours lies where it was drawn.
  for (std::size_t k = 0; k < 70; ++k)
    EXPECT_EQ(left_end_of_square(played.frames[k]), 10 + static_cast<int>(k));
}

TEST(Encoder, TimesAreThoseOfARateThatIsNoWholeNumber) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64, 29.97));
  for (int k = 0; k < 100; ++k) encoder.add(plain(64, 64, 1, 2, 3));
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.times.size(), 100U);
  // The container has ticks of at most 0.1 ms.
  for (std::size_t k = 0; k < 100; ++k)
    EXPECT_NEAR(played.times[k], static_cast<double>(k) / 29.97, 1e-4);
}

TEST(Encoder, CanBeEnteredEveryTwoSeconds) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64, 10.0));
  for (int k = 0; k < 45; ++k) encoder.add(plain(64, 64, 1, 2, 3));
  encoder.finish();
  EXPECT_THAT(play(path).keyframes, testing::ElementsAre(0, 20, 40));
}

TEST(Encoder, WritesWhatEveryPlayerTakes) {
  const fs::path path = fresh_folder() / "a.mp4";
  MovieFormat f = format(160, 90);
  f.title = "edge crack";
  f.comment = "from a script";
  Encoder encoder(path, f);
  encoder.add(moving(160, 90, 0));
  encoder.finish();
  const Played played = play(path);
  EXPECT_EQ(played.width, 160);
  EXPECT_EQ(played.height, 90);
  EXPECT_EQ(played.format, AV_PIX_FMT_YUV420P);
  EXPECT_EQ(played.profile, FF_PROFILE_H264_HIGH);
  EXPECT_EQ(played.range, AVCOL_RANGE_MPEG);
  EXPECT_EQ(played.space, AVCOL_SPC_BT709);
  EXPECT_EQ(played.primaries, AVCOL_PRI_BT709);
  EXPECT_EQ(played.transfer, AVCOL_TRC_BT709);
  EXPECT_EQ(played.metadata.at("title"), "edge crack");
  EXPECT_EQ(played.metadata.at("comment"), "from a script");
}

TEST(Encoder, KeepsColours) {
  const std::uint8_t colours[][3] = {
      {255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {36, 54, 79}, {240, 163, 92}};
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64));
  for (const auto& c : colours) encoder.add(plain(64, 64, c[0], c[1], c[2]));
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.frames.size(), std::size(colours));
  for (std::size_t k = 0; k < played.frames.size(); ++k) {
    const auto* pixel = &played.frames[k].pixels[4 * (32 * 64 + 32)];
    // 8-bit limited range rounds by 1 to 2; quantisation at crf 18 by another 1 to 2.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[2 - c], colours[k][c], 3) << k << " " << c;
  }
}

TEST(Encoder, TheIndexComesFirstSoThatMoviesStartAtOnce) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64));
  encoder.add(plain(64, 64, 1, 2, 3));
  encoder.finish();
  const std::string bytes = read_text(path);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(Encoder, BearsItsNameOnlyWhenComplete) {
  const fs::path path = fresh_folder() / "a.mp4";
  {
    Encoder encoder(path, format(64, 64));
    encoder.add(plain(64, 64, 1, 2, 3));
    EXPECT_TRUE(fs::exists(partial_name(path)));
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_FALSE(fs::exists(partial_name(path)));
  EXPECT_FALSE(fs::exists(path));
}

TEST(Encoder, AFailedMovieLeavesAnOlderOneAlone) {
  const fs::path path = fresh_folder() / "a.mp4";
  write_text(path, "old");
  { Encoder encoder(path, format(64, 64)); }
  EXPECT_EQ(read_text(path), "old");
}

TEST(Encoder, RefusesImpossibleFormats) {
  const fs::path path = fresh_folder() / "a.mp4";
  for (const MovieFormat& bad : {format(641, 360), format(640, 361), format(0, 0), format(99998, 2),
                                 format(64, 64, 0.0), format(64, 64, std::nan(""))}) {
    try {
      const Encoder encoder(path, bad);
      FAIL() << bad.width << " x " << bad.height << " at " << bad.fps;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
    }
  }
}

TEST(Encoder, AFolderThatIsNotThereIsAnError) {
  try {
    const Encoder encoder(fresh_folder() / "no" / "a.mp4", format(64, 64));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("cannot create the movie"));
  }
}

TEST(Encoder, AFolderThatVanishesIsAnError) {
  const fs::path folder = fresh_folder();
  Encoder encoder(folder / "a.mp4", format(64, 64));
  encoder.add(plain(64, 64, 1, 2, 3));
  fs::remove_all(folder);
  try {
    encoder.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
  }
}

TEST(Encoder, RefusesAFrameOfAnotherSize) {
  Encoder encoder(fresh_folder() / "a.mp4", format(64, 64));
  EXPECT_THROW(encoder.add(plain(64, 32, 1, 2, 3)), Error);
}

TEST(Encoder, NamesEveryProblemAtOnce) {
  MovieFormat bad = format(641, 64, 0.0);
  bad.crf = 0;
  bad.threads = 0;
  try {
    const Encoder encoder(fresh_folder() / "a.mp4", bad);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.problems().size(), 4U);
    EXPECT_THAT(error.what(), testing::HasSubstr("the width is 641 px, it must be even"));
  }
}

TEST(Encoder, AFullDiskIsOneClearError) {
  // The partial file is a link to a device that is always full.
  const fs::path path = fresh_folder() / "a.mp4";
  fs::create_symlink("/dev/full", partial_name(path));
  try {
    Encoder encoder(path, format(64, 64));
    for (int k = 0; k < 2000; ++k) encoder.add(moving(64, 64, k % 20));
    encoder.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("No space left on device"));
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_FALSE(fs::is_symlink(partial_name(path)));
}

}  // namespace
}  // namespace hackle
