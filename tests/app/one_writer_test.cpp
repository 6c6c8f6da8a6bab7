// SPDX-License-Identifier: MIT
// One writer per file, within a script and between programs. The remains of a killed program are
// kept.
#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "store/recording.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

struct Pair {
  const char* first;
  const char* second;
};

// The second writer is refused before anything is written; the message names the first with its
// line.
TEST(OneWriter, WithinAScript) {
  for (const auto& [first, second] : std::vector<Pair>{
           {"s:record { 'a.h5', every = 1*us }", "s:record { 'a.h5', every = 1*us }"},
           {"s:record { 'a.h5', every = 1*us }", "t:record { 'a.h5', every = 1*us }"},
           {"s:record { 'a.h5', every = 1*us }", "t:record { './a.h5', every = 1*us }"},
           {"s:record { 'a.h5', every = 1*us }", "t:record { 'sub/../a.h5', every = 1*us }"},
           {"s:record { 'a.h5', every = 1*us }", "t:record { 'a.hdf5', every = 1*us }"},
           {"s:record { 'a.h5', every = 1*us }", "io.open('a.h5', 'w')"},
           {"s:record { 'a.h5', every = 1*us }", "io.open('a.xdmf', 'a')"},
           {"s:record { 'a.h5', every = 1*us } s:run(1*us) s:close()",
            "t:record { 'a.h5', every = 1*us }"},
           {"s:movie { 'a.gif', every = 1*us }", "t:movie { 'a.gif', every = 1*us }"},
           {"s:movie { 'a.gif', every = 1*us }", "s:fork():movie { './a.gif', every = 1*us }"},
           {"s:movie { 'a.gif', every = 1*us }", "t:movie { '.a.partial.gif', every = 1*us }"},
           {"s:movie { 'a.gif', every = 1*us }", "io.output('.a.partial.gif')"},
           {"s:frame { 'a.png' }", "io.open('a.png', 'w')"},
           {"io.open('a.png', 'w'):close()", "s:frame { 'a.png' }"},
           {"s:script { 'a.lua' }", "io.open('a.lua', 'w')"}}) {
    const test::Folder folder;
    fs::create_directory(folder.path / "sub");
    const std::string told = test::message_of(
        test::scene + "t = simulate(p, { spacing = 2*mm })\n" + first + "\n" + second + "\n",
        test::quiet(folder.path));
    EXPECT_THAT(told, AllOf(HasSubstr("test.lua:9: "), HasSubstr("(test.lua:8)"),
                            HasSubstr("choose another file name")))
        << first << " " << second;
  }
}

TEST(OneWriter, EndingsDecideKinds) {
  for (const auto& [call, says] : std::vector<Pair>{
           {"s:frame { 'x.jpg' }",
            "frame: 'x.jpg' ends in '.jpg', which is no picture (one of .png, .pdf, .svg)"},
           {"contact_sheet { 'x.pdf', pictures = { 'b.png' } }", "would hold pixels only"},
           {"s:frame { 'a.mp4' }", "movie{} makes .mp4"},
           {"s:frame { 'a' }", "has no ending"},
           {"s:record { 'x.lua', every = 1*us }", "script{} makes .lua"},
           {"s:record { 'x.mp4', every = 1*us }", "(one of .h5, .hdf5; movie{} makes .mp4)"},
           {"s:record { 'x.xdmf', every = 1*us }", "one of .h5, .hdf5"},
           {"s:record { 'a:b.h5', every = 1*us }", "ParaView cannot open"},
           {"s:movie { 'x.h5', every = 1*us }", "no kind of movie"},
           {"s:script { 'x.txt' }", "no script (one of .lua)"},
           {"contact_sheet { 'x.jpg', pictures = { 'b.png' } }", "no picture"}}) {
    const test::Folder folder;
    EXPECT_THAT(test::message_of(test::scene + call, test::quiet(folder.path)), HasSubstr(says))
        << call;
    EXPECT_TRUE(fs::is_empty(folder.path)) << call;
  }
}

TEST(OneWriter, LatestPicturesMayBeWrittenAgain) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + "for k = 1, 3 do s:frame { 'latest.png' } end",
                             test::quiet(folder.path)),
            "");
}

class TwoPrograms : public testing::Test {
 protected:
  // Runs until there is a file `done`.
  static std::string long_run(const std::string& outputs) {
    return test::scene + outputs + R"(
      s:run(3*us)
      print "go" io.stdout:flush()
      while not io.open "done" do s:step(20) end
    )";
  }

  // Starts the second while the first is running; then the first runs to its end.
  void run_both(const std::string& one, const std::string& other) {
    write_text(folder.path / "one.lua", long_run(one));
    write_text(folder.path / "other.lua", test::scene + other + " s:run(3*us)");
    test::Program program(folder);
    program.at_first_word = [&](pid_t) {
      second = test::Program(folder).run({"run", "other.lua", "-o", "out"});
      for (const auto& entry : fs::recursive_directory_iterator(folder.path / "out"))
        EXPECT_TRUE(entry.path().filename().string().find('a') != std::string::npos ||
                    entry.path().string().ends_with(".inputs.json") ||
                    entry.path().filename() == ".one.running")
            << entry.path();
      write_text(folder.path / "done", "");
    };
    first = program.run({"run", "one.lua", "-o", "out"});
  }

  const test::Folder folder;
  test::Ended first, second;
};

TEST_F(TwoPrograms, DoNotRecordIntoOneFile) {
  run_both("s:record { 'a.h5', every = 1*us }", "s:record { './a.h5', every = 1*us }");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 5);
  EXPECT_THAT(second.err, AllOf(HasSubstr("other.lua:"), HasSubstr("is being written by another run"
                                                                   " (process ")));
  EXPECT_GE(Recording(folder.path / "out/a.h5").times().size(), 4U);
  EXPECT_FALSE(fs::exists(recording_lock(folder.path / "out/a.h5")));
}

TEST_F(TwoPrograms, DoNotShareASidecar) {
  run_both("s:record { 'a.h5', every = 1*us }", "s:record { 'a.hdf5', every = 1*us }");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 5) << second.err;
}

TEST_F(TwoPrograms, DoNotFilmIntoOneFile) {
  run_both("s:movie { 'a.gif', width = 320, every = 1*us }",
           "s:movie { 'a.gif', width = 320, every = 1*us }");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 5) << second.err;
}

TEST_F(TwoPrograms, ATextIsNotWrittenOverAMovie) {
  run_both("s:movie { 'a.gif', width = 320, every = 1*us }", "io.open('.a.partial.gif', 'w')");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 5) << second.err;
}

TEST_F(TwoPrograms, WithFilesOfTheirOwnGetAlong) {
  run_both("s:record { 'a.h5', every = 1*us }", "s:record { 'ab.h5', every = 1*us }");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 0) << second.err;
}

TEST_F(TwoPrograms, WhatTheFirstIsWritingCanBeLookedAt) {
  run_both("s:record { 'a.h5', every = 1*us }",
           "r = recording 'a.h5' assert(#r.times >= 3) r:frame { 'ab.png' }");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 0) << second.err;
}

TEST(AKilledRun, LeavesRunFilesThatTheNextOneKeeps) {
  const test::Folder folder;
  write_text(folder.path / "a.lua", test::scene + R"(
    s:record { "a.h5", every = 1*us }
    s:run(3*us)
    print "go" io.stdout:flush()
    s:run(wait and 1 or 1*us)
  )");
  test::Program program(folder);
  program.at_first_word = [](pid_t process) { kill(process, SIGKILL); };
  EXPECT_EQ(program.run({"run", "a.lua"}).code, 128 + SIGKILL);
  const auto next = test::Program(folder).run({"run", "a.lua"});
  EXPECT_EQ(next.code, 0) << next.err;
  EXPECT_THAT(next.err, HasSubstr("a.cut_off.h5'"));
  EXPECT_GE(Recording(folder.path / "out/a/a.cut_off.h5").times().size(), 4U);
  EXPECT_THAT(read_text(folder.path / "out/a/a.cut_off.xdmf"), HasSubstr(">a.cut_off.h5:/records"));
  EXPECT_GE(Recording(folder.path / "out/a/a.h5").times().size(), 4U);
  EXPECT_EQ(test::Program(folder).run({"run", "a.lua"}).code, 0);  // complete, hence replaced
  EXPECT_FALSE(fs::exists(folder.path / "out/a/a.cut_off_2.h5"));
}

}  // namespace
}  // namespace hackle
