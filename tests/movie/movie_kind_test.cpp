// SPDX-License-Identifier: MIT
#include "movie/movie_kind.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "movie/movie_format.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

std::string message(const std::filesystem::path& path, bool fallback, const char* missing) {
  try {
    makeable(path, fallback, [&](const std::string& name) { return name.find(missing) != 0; });
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(MovieKind, FollowsTheEndingOfTheName) {
  for (const MovieKind& kind : movie_kinds())
    EXPECT_EQ(&movie_kind("folder.mp4/name" + std::string(kind.ending)), &kind);
  EXPECT_EQ(movie_kind("CRACK.MP4").ending, ".mp4");
}

TEST(MovieKind, AnUnknownEndingIsRefusedWithTheNearestAndTheList) {
  for (const char* name : {"crack.mp5", "crack", "crack.", ".mp4", "crack.mp4.part"}) {
    try {
      movie_kind(name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_THAT(error.what(), HasSubstr(".mp4, .webm, .mkv, .mov, .gif, .apng, .webp"));
    }
  }
  try {
    movie_kind("crack.mp5");
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean '.mp4'?"));
  }
}

TEST(MovieKind, EveryEncoderIsThereOnTheMachineOfATest) {
  for (const MovieKind& kind : movie_kinds()) EXPECT_TRUE(has_encoder(kind.encoder)) << kind.name;
  EXPECT_FALSE(has_encoder("no_such_encoder"));
}

TEST(MovieKind, AMissingEncoderNamesThePackage) {
  EXPECT_THAT(message("a.mp4", false, "libx264"),
              testing::AllOf(HasSubstr("no H.264 encoder 'libx264' for 'a.mp4'"),
                             HasSubstr("Debian package libavcodec59 (or libavcodec-extra59)"),
                             HasSubstr("fallback = true")));
  EXPECT_EQ(message("a.mp4", true, "libx264"), "");
}

TEST(MovieKind, FallsBackToTheNextBestAndSaysSo) {
  const auto only_apng = [](const std::string& name) { return name == "apng"; };
  const Makeable apng = makeable("folder/a.mkv", true, only_apng);
  EXPECT_EQ(apng.path, "folder/a.apng");
  EXPECT_THAT(apng.note, testing::AllOf(HasSubstr("'ffv1'"), HasSubstr("filming 'a.apng' instead"),
                                        HasSubstr("libavcodec59")));
  const auto no_x264 = [](const std::string& name) { return name != "libx264"; };
  EXPECT_EQ(makeable("a.mp4", true, no_x264).path, "a.webm");
  // A GIF needs no encoder of FFmpeg.
  const auto nothing = [](const std::string& name) { return name.empty(); };
  for (const MovieKind& kind : movie_kinds())
    EXPECT_EQ(makeable("a" + std::string(kind.ending), true, nothing).path, "a.gif");
}

TEST(MovieKind, WhatIsThereIsTaken) {
  const Makeable made = makeable("a.mp4", true);
  EXPECT_EQ(made.path, "a.mp4");
  EXPECT_EQ(made.note, "");
}

TEST(MovieKind, ItsTableHangsTogether) {
  for (const MovieKind& kind : movie_kinds()) {
    EXPECT_TRUE(kind.settings(Profile::web)) << kind.name;
    EXPECT_TRUE(kind.settings(Profile::paper)) << kind.name;
    EXPECT_GT(kind.bytes_a_pixel, 0.0) << kind.name;
    for (const auto& settings : kind.profiles) {
      if (!settings) continue;
      EXPECT_GE(settings->crf, kind.best_crf) << kind.name;
      EXPECT_LE(settings->crf, kind.worst_crf) << kind.name;
    }
  }
}

std::string refusal(const std::filesystem::path& path, const MovieFormat& format) {
  Problems problems;
  check_settings(path, format, problems);
  std::string text;
  for (const Problem& problem : problems.list()) text += problem.what + " " + problem.remedy + "\n";
  return text;
}

// GIF has 256 colours: no other kind falls back to it while one of all colours is there.
TEST(MovieKind, FallsBackToAllColoursFirst) {
  for (const MovieKind& kind : movie_kinds()) {
    if (kind.ending == ".gif") continue;
    ASSERT_FALSE(kind.instead.empty()) << kind.ending;
    EXPECT_NE(kind.instead.front(), ".gif") << kind.ending;
  }
}

TEST(MovieFormat, RefusesWhatTheKindCannotBe) {
  MovieFormat format;
  EXPECT_EQ(refusal("a.mp4", format), "");
  format.profile = Profile::lossless;
  EXPECT_THAT(refusal("a.mp4", format),
              testing::AllOf(HasSubstr("cannot be lossless"),
                             HasSubstr("as can .mkv, .mov, .apng, .webp")));
  format = {};
  format.fps = 60.0;
  EXPECT_THAT(refusal("a.gif", format),
              HasSubstr("fps is 60, in .gif it must lie between 0.1 and 50"));
  EXPECT_EQ(refusal("a.apng", format), "");
  format = {};
  format.crf = 60;
  EXPECT_THAT(refusal("a.mp4", format), HasSubstr("between 1 (best) and 51"));
  EXPECT_EQ(refusal("a.webm", format), "");
  for (const char* path : {"a.mkv", "a.mov", "a.gif", "a.apng", "a.webp"})
    EXPECT_THAT(refusal(path, format), HasSubstr("crf has no meaning")) << path;
  format = {};
  format.hold = -1.0;
  EXPECT_THAT(refusal("a.mp4", format), HasSubstr("hold is -1 s"));
}

TEST(MovieFormat, NamesAllThatIsWrongAtOnce) {
  MovieFormat format;
  format.fps = 100.0;
  format.crf = 5;
  format.profile = Profile::lossless;
  format.hold = std::nan("");
  Problems problems;
  check_settings("a.gif", format, problems);
  EXPECT_EQ(problems.list().size(), 4U);
}

}  // namespace
}  // namespace hackle
