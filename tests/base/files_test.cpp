// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;

template <class Call>
std::string failure(Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    return error.what();
  }
  return "";
}

TEST(Files, TextComesBackAsItWasWritten) {
  const fs::path file = fresh_folder() / "a text.txt";
  const std::string text("one\ntwo\0three", 13);
  write_text(file, text);
  EXPECT_EQ(read_text(file), text);
  EXPECT_FALSE(fs::exists(partial_name(file)));
}

TEST(Files, PartialNamesAreHiddenAndKeepTheEnding) {
  EXPECT_EQ(partial_name("a/movie.mp4"), "a/.movie.partial.mp4");
  EXPECT_EQ(partial_name("movie.mp4"), ".movie.partial.mp4");
}

TEST(Files, AMissingFileIsNamed) {
  EXPECT_THAT(failure([] { read_text("no/such.lua"); }),
              testing::HasSubstr("cannot read 'no/such.lua': No such file"));
  EXPECT_THAT(failure([] { read_text("/"); }), testing::HasSubstr("is a folder, not a file"));
}

TEST(Files, ShadersAndAssetsAreFound) {
  EXPECT_TRUE(fs::exists(data_file("shaders/colours.frag")));
  EXPECT_THAT(failure([] { data_file("shaders/none.frag"); }), testing::HasSubstr("HACKLE_DATA"));
}

TEST(CheckWritable, LooksAtTheNearestFolderAndCreatesNothing) {
  const fs::path folder = fresh_folder();
  EXPECT_NO_THROW(check_writable(folder / "a/b/c.mp4"));
  EXPECT_FALSE(fs::exists(folder / "a"));
  EXPECT_THAT(failure([&] { check_writable(folder); }), testing::HasSubstr("it is a folder"));
}

TEST(CheckWritable, RefusesAFileInPlaceOfAFolder) {
  const fs::path file = fresh_folder() / "file";
  write_text(file, "x");
  EXPECT_THAT(failure([&] { check_writable(file / "a.mp4"); }),
              testing::HasSubstr("is not a folder"));
}

TEST(MakeFolder, SaysWhyItCannot) {
  EXPECT_THAT(failure([] { make_folder_of("/proc/hackle/a.mp4"); }),
              testing::HasSubstr("cannot create the folder '/proc/hackle'"));
}

TEST(RealPath, FollowsLinksAlsoToNowhere) {
  const test::Folder own;
  const fs::path folder = fs::canonical(own.path);
  fs::create_directories(folder / "a/b");
  fs::create_directory_symlink("a/b", folder / "short");
  fs::create_symlink("../a/new", folder / "a/dangling");
  fs::create_symlink(folder / "a/dangling", folder / "twice");
  EXPECT_EQ(real_path(folder / "short/.."), folder / "a");
  EXPECT_EQ(real_path(folder / "short/x/./y"), folder / "a/b/x/y");
  EXPECT_EQ(real_path(folder / "twice"), folder / "a/new");
  EXPECT_EQ(real_path(folder / "none/../../.."), folder.parent_path().parent_path());
  EXPECT_EQ(real_path("/../.."), "/");
  EXPECT_EQ(real_path(""), fs::canonical("."));
  EXPECT_EQ(real_path("x"), fs::canonical(".") / "x");
}

TEST(RealPath, DoesNotRunInCircles) {
  const test::Folder folder;
  fs::create_symlink("two", folder.path / "one");
  fs::create_symlink("one/x", folder.path / "two");
  EXPECT_THAT(failure([&] { real_path(folder.path / "one"); }), testing::HasSubstr("in a circle"));
}

}  // namespace
}  // namespace hackle
