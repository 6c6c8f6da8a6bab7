// SPDX-License-Identifier: MIT
// What is left of movies of programs that were killed, and of disks that are full.
#include "movie/rescue.hpp"

#include <cmath>
#include <csignal>
#include <cstdlib>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "movie/encoder.hpp"
#include "movie/make_film.hpp"
#include "movie/pictures.hpp"
#include "movie/player.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::format;
using test::moving;
using test::play;
using test::Played;
using testing::HasSubstr;

constexpr int filmed = 90;  // frames, at 25 a second

// Another program films and is killed.
void film_and_die(const fs::path& path, double fps = 25.0) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const PartialFile partial(path);
    const auto film = make_film(path, format(160, 90, fps));
    for (int k = 0; k < filmed; ++k) film->add(moving(160, 90, k));
    std::raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

class Killed : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { film_and_die(path); }

  const test::Folder folder;
  const fs::path path = folder.path / ("a" + GetParam());
};

INSTANTIATE_TEST_SUITE_P(Each, Killed,
                         testing::Values(".mp4", ".webm", ".mkv", ".mov", ".gif", ".apng", ".webp"),
                         [](const auto& tested) { return tested.param.substr(1); });

// Every frame shows what was filmed at its time. The last ones of H.264 may lack those between
// them.
void expect_all_but_the_last_second(const Played& played) {
  ASSERT_GE(played.frames.size(), static_cast<std::size_t>(filmed - 25));
  for (std::size_t at = 0; at < played.frames.size(); ++at) {
    const auto k = static_cast<std::size_t>(std::lround(played.times[at] / 0.04));
    EXPECT_TRUE(k == at || at + 4 >= played.frames.size()) << k << " " << at;
    EXPECT_NEAR(played.times[at], 0.04 * static_cast<double>(k), 1e-6);
    const auto* row = &played.frames[at].pixels[25 * 640];
    EXPECT_LT(row[4 * (10 + k - 1)], 145) << k;
    EXPECT_GT(row[4 * (10 + k)], 145) << k;
  }
}

TEST_P(Killed, PlaysUnderItsPartialName) {
  EXPECT_FALSE(fs::exists(path));
  expect_all_but_the_last_second(play(partial_name(path)));
}

TEST_P(Killed, IsKeptAsACompleteMovie) {
  const auto rescued = rescue(path);
  ASSERT_TRUE(rescued);
  EXPECT_EQ(rescued->file.filename(), "a.cut_off" + GetParam());
  EXPECT_FALSE(fs::exists(partial_name(path)));
  const Played played = play(rescued->file);
  expect_all_but_the_last_second(played);
  EXPECT_EQ(rescued->length.frames, static_cast<std::int64_t>(played.frames.size()));
  EXPECT_NEAR(rescued->length.seconds, played.times.back() + 0.04, 1e-3);
  EXPECT_FALSE(rescue(path));
}

TEST_P(Killed, DoesNotTakeTheNameOfAnother) {
  write_text(folder.path / ("a.cut_off" + GetParam()), "of an earlier one");
  const auto rescued = rescue(path);
  ASSERT_TRUE(rescued);
  EXPECT_EQ(rescued->file.filename(), "a.cut_off_2" + GetParam());
}

TEST(Rescue, AFilmOfFewFramesASecondLacksFew) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.mp4";
  film_and_die(path, 4.0);
  // Half a second of looking ahead, three frames between two others, half a second of fragment.
  EXPECT_GE(play(partial_name(path)).frames.size(), static_cast<std::size_t>(filmed - 8));
}

TEST(Rescue, FindsNothingWhereNothingWasFilmed) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.mp4";
  EXPECT_FALSE(rescue(path));
  write_text(partial_name(path), "");
  EXPECT_FALSE(rescue(path));
  write_text(partial_name(path), "no movie at all");
  EXPECT_FALSE(rescue(path));
  for (const auto& entry : fs::directory_iterator(folder.path))
    EXPECT_EQ(entry.path().filename(), ".a.partial.mp4");
}

TEST(Rescue, LeavesAMovieAloneThatIsBeingFilmed) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.gif";
  Encoder encoder(path, format(160, 90));
  encoder.add(moving(160, 90, 0));
  EXPECT_FALSE(rescue(path));
  try {
    const Encoder second(path, format(160, 90));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), HasSubstr("is being written by another run"));
  }
  encoder.finish();
  EXPECT_EQ(play(path).frames.size(), 1U);
}

// In a process of its own, files may grow to so many bytes only; exits with 0 when the film ends
// in the one error that it should.
void film_on_a_full_disk(const fs::path& path, rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    Encoder encoder(path, format(160, 90));
    for (int k = 0; k < 300; ++k) encoder.add(test::noise(160, 90, static_cast<unsigned>(k)));
    encoder.finish();
    std::_Exit(2);
  } catch (const Error& error) {
    const std::string text = error.what();
    const bool clear = text.find("cannot write the movie '" + path.string()) == 0 &&
                       text.find("make room") != std::string::npos;
    std::_Exit(clear && error.problems().size() == 1 && error.kind() == ErrorKind::files ? 0 : 3);
  }
}

TEST(FullDisk, IsOneClearErrorAndEarlierFilesStay) {
  for (const std::string ending : {".mp4", ".webm", ".mkv", ".mov", ".gif", ".apng", ".webp"}) {
    const test::Folder folder;
    const fs::path path = folder.path / ("a" + ending);
    write_text(path, "of an earlier run");
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) film_on_a_full_disk(path, 100'000);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0) << ending;
    EXPECT_EQ(read_text(path), "of an earlier run") << ending;
    EXPECT_FALSE(fs::exists(partial_name(path))) << ending;
  }
}

TEST(FullDisk, WithoutRoomForTwoTheFragmentsAreTheMovie) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.mp4";
  // The copy with the index in front cannot be created.
  fs::create_directories(folder.path / ".a.indexed.mp4" / "in_the_way");
  Encoder encoder(path, format(160, 90, 25.0));
  for (int k = 0; k < 60; ++k) encoder.add(moving(160, 90, k));
  encoder.finish();
  EXPECT_EQ(play(path).frames.size(), 60U);
}

}  // namespace
}  // namespace hackle
