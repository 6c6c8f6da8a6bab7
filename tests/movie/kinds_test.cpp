// SPDX-License-Identifier: MIT
// What holds for every kind of movie, and what each promises.
#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/encoder.hpp"
#include "movie/pictures.hpp"
#include "movie/player.hpp"
#include "movie/read_film.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::difference;
using test::format;
using test::moving;
using test::noise;
using test::plain;
using test::play;
using test::Played;

template <class Picture>
Played film(const fs::path& path, const MovieFormat& format, int frames, Picture picture) {
  Encoder encoder(path, format);
  for (int k = 0; k < frames; ++k) encoder.add(picture(k));
  encoder.finish();
  return play(path);
}

// In every test, each kind once.
class Kinds : public testing::TestWithParam<std::string> {
 protected:
  const test::Folder folder;
  const fs::path path = folder.path / ("a" + GetParam());
};

INSTANTIATE_TEST_SUITE_P(Each, Kinds,
                         testing::Values(".mp4", ".webm", ".mkv", ".mov", ".gif", ".apng", ".webp"),
                         [](const auto& tested) { return tested.param.substr(1); });

TEST_P(Kinds, ShowEveryFrameAtItsTime) {
  const auto picture = [](int k) { return moving(160, 90, k); };
  const Played played = film(path, format(160, 90, 25.0), 70, picture);
  EXPECT_EQ(played.width, 160);
  EXPECT_EQ(played.height, 90);
  ASSERT_EQ(played.frames.size(), 70U);
  for (int k = 0; k < 70; ++k) {
    // 40 ms is a whole number of ticks of every kind.
    EXPECT_NEAR(played.times[static_cast<std::size_t>(k)], 0.04 * k, 1e-6);
    // The square is where it was drawn: the nearest other frame differs in two of its columns.
    const Image& seen = played.frames[static_cast<std::size_t>(k)];
    const auto grey = [&](int x) {
      return seen.pixels[static_cast<std::size_t>(25 * 640 + 4 * x)];
    };
    EXPECT_LT(grey(10 + k - 1), 145) << k;
    EXPECT_GT(grey(10 + k), 145) << k;
  }
}

TEST_P(Kinds, TimesDoNotDrift) {
  const auto picture = [](int k) { return moving(160, 90, k); };
  const Played played = film(path, format(160, 90, 30.0), 100, picture);
  ASSERT_EQ(played.times.size(), 100U);
  // To the nearest tick; in WebP, to the one before.
  const double off = GetParam() == ".gif" ? 0.0051 : GetParam() == ".webp" ? 0.001 : 0.00051;
  for (int k = 0; k < 100; ++k) {
    // FFmpeg reads the 1/30 s of an APNG as 0.03333 s.
    const double read = GetParam() == ".apng" ? k * 0.03333 : k / 30.0;
    EXPECT_NEAR(played.times[static_cast<std::size_t>(k)], read, off) << k;
  }
}

TEST_P(Kinds, HoldTheLastFrame) {
  MovieFormat held = format(160, 90, 10.0);
  held.hold = 1.5;
  const auto picture = [](int k) { return moving(160, 90, 20 * k); };
  const Played played = film(path, held, 3, picture);
  ASSERT_FALSE(played.frames.empty());
  EXPECT_LE(difference(played.frames.back(), picture(2)), GetParam() == ".webm" ? 60 : 40);
  if (GetParam() == ".webp") {
    EXPECT_NEAR(played.seconds, 1.8, 1e-9);
  } else if (GetParam() == ".gif") {  // one frame that is shown for longer
    EXPECT_EQ(played.frames.size(), 3U);
    EXPECT_NEAR(played.times.back(), 0.2, 1e-6);
  } else {
    EXPECT_EQ(played.frames.size(), 3U + 15U);
    EXPECT_NEAR(played.times.back(), 1.7, 1e-3);
  }
}

TEST_P(Kinds, TakeEveryProfileTheyHave) {
  for (const Profile profile :
       {Profile::preview, Profile::web, Profile::paper, Profile::lossless}) {
    MovieFormat f = format(64, 48);
    f.profile = profile;
    Problems problems;
    check_settings(path, f, problems);
    const bool refused = !problems.empty();
    const bool lossy = GetParam() == ".mp4" || GetParam() == ".webm" || GetParam() == ".gif";
    EXPECT_EQ(refused, lossy && profile == Profile::lossless);
    if (refused) continue;
    const auto picture = [](int k) {
      return plain(64, 48, static_cast<std::uint8_t>(40 * k), 90, 200);
    };
    const Played played = film(path, f, 3, picture);
    ASSERT_EQ(played.frames.size(), 3U);
    for (int k = 0; k < 3; ++k)
      // WebP of preview quality is the coarsest.
      EXPECT_LE(difference(played.frames[static_cast<std::size_t>(k)], picture(k)), 10) << k;
  }
}

TEST_P(Kinds, WhatIsLosslessGivesBackEveryPixel) {
  if (!movie_kind(path).settings(Profile::lossless)) return;
  MovieFormat f = format(62, 46);
  f.profile = Profile::lossless;
  f.threads = 2;
  const auto picture = [](int k) { return noise(62, 46, static_cast<unsigned>(k)); };
  const Played played = film(path, f, 35, picture);
  ASSERT_EQ(played.frames.size(), 35U);
  for (int k = 0; k < 35; ++k)
    EXPECT_EQ(difference(played.frames[static_cast<std::size_t>(k)], picture(k)), 0) << k;
}

TEST_P(Kinds, SayWhereTheyComeFrom) {
  MovieFormat f = format(64, 48);
  f.title = "edge crack";
  f.comment = "Made by Hackle";
  const Played played = film(path, f, 2, [](int k) { return moving(64, 48, k); });
  EXPECT_EQ(played.frames.size(), 2U);
  EXPECT_THAT(read_text(path), testing::HasSubstr("edge crack"));
  EXPECT_THAT(read_text(path), testing::HasSubstr("Made by Hackle"));
  if (GetParam() == ".webp" || GetParam() == ".apng") return;  // FFmpeg does not read it there
  EXPECT_EQ(played.metadata.at("comment"), "Made by Hackle");
}

TEST_P(Kinds, AreReadAsTheyWereWritten) {
  MovieFormat f = format(64, 48, 25.0);
  f.title = "edge <crack>";
  f.comment = "Made by Hackle from \"a & b.lua\"";
  film(path, f, 50, [](int k) { return moving(64, 48, k / 2); });
  const FilmFacts facts = facts_of_film(path);
  EXPECT_EQ(facts.comment, f.comment);
  EXPECT_EQ(facts.title, GetParam() == ".gif" ? "" : f.title);
  EXPECT_EQ(facts.width, 64);
  EXPECT_EQ(facts.height, 48);
  EXPECT_NEAR(facts.length.seconds, 2.0, 0.02);
  // Two equal pictures may be one that is shown for longer.
  EXPECT_GE(facts.length.frames, 25);
  EXPECT_LE(facts.length.frames, 50);
}

TEST_P(Kinds, AreKnownByWhatIsInThem) {
  std::vector<std::string> texts{"", "RIFF", "GIF89a", "no movie at all"};
  if (GetParam() == ".webp") texts.emplace_back("RIFF0000WEBPANMF");
  for (const std::string& text : texts) {
    write_text(path, text);
    EXPECT_THROW(facts_of_film(path), Error) << text;
  }
}

TEST_P(Kinds, ABetterCrfIsCloserAndLarger) {
  if (!movie_kind(path).takes_crf()) return;
  const auto picture = [](int k) { return noise(64, 48, static_cast<unsigned>(k), true); };
  MovieFormat f = format(64, 48);
  std::uintmax_t size = 0;
  double error = 1e9;
  for (const int crf : {50, 25, 1}) {
    f.crf = crf;
    const Played played = film(path, f, 5, picture);
    ASSERT_EQ(played.frames.size(), 5U);
    double sum = 0.0;
    for (std::size_t at = 0; at < played.frames[4].pixels.size(); ++at)
      sum += std::abs(played.frames[4].pixels[at] - picture(4).pixels[at]);
    EXPECT_LT(sum, error);
    EXPECT_GT(fs::file_size(path), size);
    error = sum;
    size = fs::file_size(path);
  }
}

TEST(GifKind, APictureOfFewColoursIsExact) {
  const test::Folder folder;
  // Sixty greys, four levels apart; and so many pixels without pattern that the table of codes
  // fills up and is cleared several times.
  const auto picture = [](int k) { return noise(254, 130, static_cast<unsigned>(k), true); };
  const Played played = film(folder.path / "a.gif", format(254, 130, 50.0), 4, picture);
  ASSERT_EQ(played.frames.size(), 4U);
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(difference(played.frames[static_cast<std::size_t>(k)], picture(k)), 0) << k;
}

// A smooth picture in more colours than there is room for.
Image ramp(int shift) {
  Image image(256, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x) {
      auto* pixel = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
      pixel[0] = static_cast<std::uint8_t>(x);
      pixel[1] = static_cast<std::uint8_t>(255 - x);
      pixel[2] = static_cast<std::uint8_t>(2 * y + shift);
    }
  return image;
}

TEST(GifKind, ManyColoursAreNear) {
  const test::Folder folder;
  const auto picture = [](int k) { return ramp(60 * k); };
  const Played played = film(folder.path / "a.gif", format(256, 64), 3, picture);
  ASSERT_EQ(played.frames.size(), 3U);
  for (int k = 0; k < 3; ++k)
    EXPECT_LE(difference(played.frames[static_cast<std::size_t>(k)], picture(k)), 52) << k;
}

TEST(GifKind, ColoursThatComeLaterGetAPlaceToo) {
  const test::Folder folder;
  const std::uint8_t colours[][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {36, 54, 79}};
  const auto picture = [&](int k) {
    return plain(64, 64, colours[k][0], colours[k][1], colours[k][2]);
  };
  const Played played = film(folder.path / "a.gif", format(64, 64), 4, picture);
  ASSERT_EQ(played.frames.size(), 4U);
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(difference(played.frames[static_cast<std::size_t>(k)], picture(k)), 0) << k;
}

TEST(WebpKind, TheLastFrameIsShownAsLongAsTheOthers) {
  const test::Folder folder;
  const auto picture = [](int k) { return moving(160, 90, k); };
  const Played played = film(folder.path / "a.webp", format(160, 90, 10.0), 25, picture);
  EXPECT_NEAR(played.seconds, 2.5, 1e-9);
}

TEST(WebmKind, IsVp9InTheColoursOfH264) {
  const test::Folder folder;
  const Played played =
      film(folder.path / "a.webm", format(64, 48), 2, [](int) { return plain(64, 48, 255, 0, 0); });
  EXPECT_EQ(played.format, AV_PIX_FMT_YUV420P);
  EXPECT_EQ(played.range, AVCOL_RANGE_MPEG);
  EXPECT_EQ(played.space, AVCOL_SPC_BT709);
}

}  // namespace
}  // namespace hackle
