// SPDX-License-Identifier: MIT
// The pictures of a movie, kept beside it.
#include "movie/kept_frames.hpp"

#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/pictures.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::moving;
using testing::HasSubstr;

constexpr FrameFormat kept_format{160, 90, 3};
constexpr int kept_count = 6;

void keep(KeptFrames& frames, int from, int to) {
  for (int k = from; k < to; ++k)
    frames.add(moving(160, 90, k), kept_format, "note " + std::to_string(k));
}

// Returns the number of frames that come back, each as it was given.
int frames_back(const fs::path& movie) {
  KeptFramesReader reader(movie);
  EXPECT_EQ(reader.format().width, 160);
  EXPECT_EQ(reader.format().height, 90);
  EXPECT_EQ(reader.format().threads, 3);
  int count = 0;
  for (; reader.next(); ++count) {
    EXPECT_EQ(reader.picture().pixels, moving(160, 90, count).pixels);
    EXPECT_EQ(reader.note(), "note " + std::to_string(count));
  }
  EXPECT_FALSE(reader.next());
  return count;
}

std::string refusal_of_frames(const fs::path& movie) {
  try {
    KeptFramesReader reader(movie);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    return error.what();
  }
}

TEST(KeptFrames, ComeBackWithTheirNotes) {
  const test::Folder folder;
  const fs::path movie = folder.path / "a.mp4";
  EXPECT_EQ(kept_frames_name(movie), folder.path / ".a.mp4.frames");
  KeptFrames frames(movie);
  keep(frames, 0, kept_count);
  EXPECT_EQ(frames_back(movie), kept_count);  // without an end: a killed program makes none
}

TEST(KeptFrames, GoOnBehindAnyOfThem) {
  const test::Folder folder;
  const fs::path movie = folder.path / "a.mp4";
  for (const int kept : {1, 3, kept_count}) {
    {
      KeptFrames frames(movie);
      keep(frames, 0, kept_count);
    }
    KeptFramesReader reader(movie);
    for (int k = 0; k < kept; ++k) ASSERT_TRUE(reader.next());
    KeptFrames frames(movie, reader, kept);
    EXPECT_EQ(frames_back(movie), kept);
    keep(frames, kept, kept_count + 2);
    EXPECT_EQ(frames_back(movie), kept_count + 2);
    frames.wait_for(kept_count + 2);
  }
}

TEST(KeptFrames, AreWholeOrNotThereWhereverTheFileEnds) {
  const test::Folder folder;
  const fs::path movie = folder.path / "a.mp4", file = kept_frames_name(movie);
  {
    KeptFrames frames(movie);
    keep(frames, 0, kept_count);
  }
  std::vector<std::int64_t> ends;
  for (KeptFramesReader reader(movie); reader.next();) ends.push_back(reader.end());
  ASSERT_EQ(ends.back(), static_cast<std::int64_t>(fs::file_size(file)));
  for (auto size = ends.back(); size >= ends.front(); size -= 13) {
    fs::resize_file(file, static_cast<std::uintmax_t>(size));
    EXPECT_EQ(frames_back(movie),
              std::ranges::count_if(ends, [&](auto end) { return end <= size; }));
  }
}

TEST(KeptFrames, AChangedByteEndsThem) {
  const test::Folder folder;
  const fs::path movie = folder.path / "a.mp4", file = kept_frames_name(movie);
  {
    KeptFrames frames(movie);
    keep(frames, 0, kept_count);
  }
  const std::string whole = read_text(file);
  std::vector<std::size_t> ends;
  for (KeptFramesReader reader(movie); reader.next();)
    ends.push_back(static_cast<std::size_t>(reader.end()));
  for (std::size_t at = ends[0]; at < whole.size(); at += 7) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    write_text(file, changed);
    const auto before = std::ranges::count_if(ends, [&](std::size_t end) { return end <= at; });
    EXPECT_EQ(frames_back(movie), before) << at;
  }
}

TEST(KeptFrames, AreRefusedWhereThereAreNone) {
  const test::Folder folder;
  const fs::path movie = folder.path / "a.mp4", file = kept_frames_name(movie);
  EXPECT_THAT(refusal_of_frames(movie), HasSubstr("No such file"));
  EXPECT_THAT(refusal_of_frames(movie), HasSubstr("--fresh"));
  for (const std::string& text :
       {std::string(), std::string("Hackle frames 1\n"),
        "Hackle frames 1\n" + std::string(12, '\xff'),
        "Hackle frames 2\n" + std::string("\1\0\0\0\1\0\0\0\1\0\0\0", 12)}) {
    write_text(file, text);
    EXPECT_THAT(refusal_of_frames(movie), HasSubstr("it does not begin as it should"));
  }
}

TEST(KeptFrames, WhoWaitsForThemIsTold) {
  const test::Folder folder;
  KeptFrames frames(folder.path / "a.mp4");
  frames.wait_for(0);
  std::thread other([&] { keep(frames, 0, 2); });
  frames.wait_for(2);
  other.join();
  frames.give_up();
  frames.wait_for(2);
  try {
    frames.wait_for(3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), HasSubstr("a.mp4' has failed"));
  }
}

}  // namespace
}  // namespace hackle
