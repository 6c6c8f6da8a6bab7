// SPDX-License-Identifier: MIT
#include "output/files/output_names.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Names : public testing::Test {
 protected:
  // Returns the message of claiming a name, "" if it is free.
  std::string claim(const std::string& who, const fs::path& name, FileKind kind) {
    try {
      names.claim(who, folder.path / name, kind);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }
  std::string record(const fs::path& name) { return claim("record", name, FileKind::run_file); }
  std::string film(const fs::path& name) { return claim("movie", name, FileKind::movie); }
  std::string frame(const fs::path& name) { return claim("frame", name, FileKind::picture); }
  std::string text(const fs::path& name) { return claim("io.open", name, FileKind::text); }

  const test::Folder folder;
  OutputNames names;
};

TEST_F(Names, ASecondWriterOfARunFileIsRefusedAndTheFirstNamed) {
  names.place = [] { return "a.lua:12"; };
  EXPECT_EQ(record("a.h5"), "");
  EXPECT_THAT(record("a.h5"), HasSubstr("/a.h5' is already written by record (a.lua:12)"));
}

TEST_F(Names, AFileHasManyNames) {
  fs::create_directory(folder.path / "sub");
  fs::create_directory_symlink(folder.path / "sub", folder.path / "link");
  // which does not exist yet
  fs::create_symlink(folder.path / "sub/c.h5", folder.path / "to_c.h5");
  EXPECT_EQ(record("a.h5"), "");
  EXPECT_EQ(record("sub/b.h5"), "");
  EXPECT_EQ(record("sub/c.h5"), "");
  for (const char* name : {"./a.h5", "sub/../a.h5", ".//a.h5", "link/../a.h5", "none/../a.h5",
                           "link/b.h5", "sub/./b.h5", "to_c.h5"})
    EXPECT_THAT(record(name), HasSubstr("already written by record")) << name;
}

TEST_F(Names, RunFilesOfOneSidecarDoNotGoTogether) {
  EXPECT_EQ(record("a.h5"), "");
  EXPECT_THAT(record("a.hdf5"), HasSubstr("would take 'a.xdmf', which goes with"));
  EXPECT_THAT(record("a.H5"), HasSubstr("would take 'a.xdmf'"));
  EXPECT_THAT(text("a.xdmf"), HasSubstr("which goes with"));
  EXPECT_THAT(text(".a.partial.xdmf"), HasSubstr("which goes with"));
  EXPECT_EQ(record("b.h5"), "");
}

TEST_F(Names, WhatIsNotCompleteHasAName) {
  EXPECT_EQ(film("a.mp4"), "");
  EXPECT_THAT(film(".a.partial.mp4"), HasSubstr("would take '.a.partial.mp4'"));
  EXPECT_THAT(film(".a.indexed.mp4"), HasSubstr("would take '.a.indexed.mp4'"));
  EXPECT_THAT(text(".a.partial.mp4"), HasSubstr("which goes with"));
}

TEST_F(Names, PicturesAndTextsMayBeWrittenAgainByTheirOwnKind) {
  EXPECT_EQ(frame("latest.png"), "");
  EXPECT_EQ(frame("latest.png"), "");
  EXPECT_EQ(claim("contact_sheet", "./latest.png", FileKind::picture), "");
  EXPECT_THAT(text("latest.png"), HasSubstr("already written by contact_sheet"));
  EXPECT_EQ(text("a.csv"), "");
  EXPECT_EQ(text("a.csv"), "");
  EXPECT_EQ(claim("script", "a.lua", FileKind::script), "");
  EXPECT_EQ(claim("script", "a.lua", FileKind::script), "");
  EXPECT_THAT(text("a.lua"), HasSubstr("already written by script"));
}

// What a run keeps by itself it also removes.
TEST_F(Names, ACheckpointIsWrittenAgainByWhoWroteItAlone) {
  EXPECT_EQ(claim("save", "a.ckpt", FileKind::checkpoint), "");
  EXPECT_EQ(claim("save", "a.ckpt", FileKind::checkpoint), "");
  EXPECT_THAT(claim("checkpoint", "a.ckpt", FileKind::checkpoint), HasSubstr("written by save"));
  EXPECT_THAT(claim("save", "a_prev.ckpt", FileKind::checkpoint), HasSubstr("a_prev.ckpt"));
}

TEST_F(Names, NothingIsWrittenOverAMovieOrARunFile) {
  EXPECT_EQ(film("a.mp4"), "");
  EXPECT_EQ(record("a.h5"), "");
  for (const char* name : {"a.mp4", "a.h5"}) {
    EXPECT_NE(frame(name), "") << name;
    EXPECT_NE(text(name), "") << name;
    EXPECT_NE(film(name), "") << name;
  }
}

TEST_F(Names, AtThePromptWhatIsCompleteMayBeWrittenAgain) {
  EXPECT_EQ(record("a.h5"), "");
  names.complete(folder.path / "a.h5");
  EXPECT_NE(record("a.h5"), "");  // a script would lose the first
  names.replaces_complete = true;
  EXPECT_EQ(record("a.h5"), "");
  EXPECT_NE(record("a.h5"), "");  // which is not complete
}

TEST_F(Names, AreKnownWithAllThatGoesWithThem) {
  EXPECT_EQ(record("a.h5"), "");
  EXPECT_TRUE(names.is_claimed(folder.path / "./a.h5"));
  EXPECT_TRUE(names.is_claimed(folder.path / "a.xdmf"));
  EXPECT_FALSE(names.is_claimed(folder.path / "a.mp4"));
}

TEST_F(Names, WhatAnotherProgramWritesIsRefused) {
  const PartialFile movie(folder.path / "a.mp4");
  const HeldFile run(recording_lock(folder.path / "a.h5"), "a.h5");
  const std::string process = "(process " + std::to_string(getpid()) + ")";
  EXPECT_THAT(film("a.mp4"), HasSubstr("is being written by another run " + process));
  EXPECT_THAT(record("a.hdf5"), HasSubstr("is being written by another run"));
  EXPECT_THAT(text("a.h5"), HasSubstr("is being written by another run"));
  EXPECT_THAT(text(".a.partial.mp4"), HasSubstr("is being written by another run"));
  EXPECT_EQ(frame("a.png"), "");
  names.rehearses = true;
  EXPECT_EQ(film("a.mp4"), "");
}

TEST(Endings, DecideTheKindAndWrongOnesAreRefusedWithTheRightOnes) {
  const auto refusal = [](const char* who, const char* name, FileKind kind) -> std::string {
    try {
      check_ending(who, name, kind);
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      return error.what();
    }
  };
  EXPECT_EQ(refusal("frame", "a.png", FileKind::picture), "");
  EXPECT_EQ(refusal("frame", "a.PNG", FileKind::picture), "");
  EXPECT_EQ(refusal("record", "a.hdf5", FileKind::run_file), "");
  EXPECT_EQ(refusal("movie", "a.webm", FileKind::movie), "");
  EXPECT_EQ(refusal("io.open", "a.anything", FileKind::text), "");
  EXPECT_EQ(refusal("frame", "x.jpg", FileKind::picture),
            "frame: 'x.jpg' ends in '.jpg', which is no picture (one of .png, .pdf, .svg)");
  EXPECT_EQ(refusal("frame", "a.mp4", FileKind::picture),
            "frame: 'a.mp4' ends in '.mp4', which is no picture (one of .png, .pdf, .svg; movie{} "
            "makes .mp4)");
  EXPECT_EQ(refusal("record", "x.lua", FileKind::run_file),
            "record: 'x.lua' ends in '.lua', which is no run file (one of .h5, .hdf5; script{} "
            "makes .lua)");
  EXPECT_EQ(refusal("record", "x.h6", FileKind::run_file),
            "record: 'x.h6' ends in '.h6', which is no run file (did you mean '.h5'?) (one of .h5, "
            ".hdf5)");
  EXPECT_EQ(refusal("record", "run", FileKind::run_file),
            "record: 'run' has no ending (one of .h5, .hdf5)");
  for (const char* name : {"x.png", "x.pdf", "x.SVG"})
    EXPECT_EQ(refusal("frame", name, FileKind::picture), "") << name;
  for (const char* name : {"x.eps", "x.jpg", "x", "x.", ".png", "x.png "})
    EXPECT_NE(refusal("frame", name, FileKind::picture), "") << name;
}

}  // namespace
}  // namespace hackle
