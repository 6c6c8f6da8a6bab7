// SPDX-License-Identifier: MIT
// stdin, stdout and stderr that are closed, full or unread, in every combination.
#include <fstream>
#include <optional>

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "faults/faulty_program.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::Stream;
using test::Streams;
using testing::HasSubstr;

constexpr std::array all_outputs{Stream::usual, Stream::closed, Stream::full, Stream::unread};
constexpr std::array broken{Stream::closed, Stream::full, Stream::unread};
constexpr std::array names{"usual", "closed", "full", "unread"};

std::string text_of(const Streams& streams) {
  std::string text;
  for (const Stream stream : streams) text += std::string(names[static_cast<int>(stream)]) + " ";
  return text;
}

class Streaming : public testing::Test {
 protected:
  Ended run(const std::vector<std::string>& words, const Streams& streams) const {
    return program_.run(words, {.streams = streams});
  }

  void write(const char* name, const std::string& text) const {
    write_text(folder_.path / name, text);
  }
  std::string read(const std::string& name) const {
    return test::Program::text_of(folder_.path / name);
  }

  test::Folder folder_;
  test::FaultyProgram program_{folder_};
};

// Files opened early would get the lowest free descriptors.
const std::string results = test::scene + R"(
  s:movie { "a.mp4", every = 1*us, width = 320 }
  s:record { "a.h5", every = 1*us }
  s:run(2*us)
  s:close()
  local f = io.open("hash.txt", "w") f:write(s.hash) f:close()
)";

TEST_F(Streaming, NoneChangesAResult) {
  write("a.lua", results);
  ASSERT_EQ(run({"run", "a.lua", "-o", "right"}, {}).code, 0);
  int tried = 0;
  for (const Stream in : {Stream::usual, Stream::closed})
    for (const Stream out : all_outputs)
      for (const Stream err : all_outputs) {
        const Streams streams{in, out, err};
        SCOPED_TRACE(text_of(streams));
        fs::remove_all(folder_.path / "out");
        EXPECT_EQ(run({"run", "a.lua"}, streams).code, 0);
        EXPECT_EQ(read("out/a/hash.txt"), read("right/hash.txt"));
        EXPECT_EQ(read("out/a/a.mp4"), read("right/a.mp4"));
        EXPECT_EQ(read("out/a/a.h5").size(), read("right/a.h5").size());
        ++tried;
      }
  EXPECT_EQ(tried, 32);
}

TEST_F(Streaming, WhatIsPrintedAndLostIsSaidAtTheEnd) {
  write("a.lua", "print 'talk' io.open('a.txt', 'w'):write('whole'):close()");
  for (const Stream out : {Stream::closed, Stream::full}) {
    const Ended ended = run({"run", "a.lua"}, {Stream::usual, out, Stream::usual});
    EXPECT_EQ(ended.code, 5);
    EXPECT_THAT(ended.err, HasSubstr("output was lost"));
    EXPECT_EQ(read("out/a/a.txt"), "whole");
    fs::remove_all(folder_.path / "out");
  }
}

// As with `| head`, once it has read enough.
TEST_F(Streaming, AScriptThatNobodyReadsEndsAndCompletesItsMovie) {
  write("a.lua", test::scene +
                     "s:movie { 'a.mp4', every = 1*us, width = 320 }\n"
                     "while true do s:run(1*us) print(s.time) end");
  const Ended ended = run({"run", "a.lua"}, {Stream::usual, Stream::unread, Stream::usual});
  EXPECT_EQ(ended.code, 5) << ended.err;
  EXPECT_TRUE(test::is_whole_mp4(folder_.path / "out/a/a.mp4"));
}

TEST_F(Streaming, AFailureStaysTheFailureItIs) {
  write("a.lua", "print 'talk' error 'no'");
  write("b.lua", "print 'talk' plate { width = -1 }");
  write("c.lua", "print 'talk' os.exit(42)");
  for (const Stream err : all_outputs) {
    const Streams streams{Stream::usual, Stream::full, err};
    EXPECT_EQ(run({"run", "a.lua"}, streams).code, 3) << text_of(streams);
    EXPECT_EQ(run({"run", "b.lua"}, streams).code, 4) << text_of(streams);
    EXPECT_EQ(run({"run", "c.lua"}, streams).code, 42) << text_of(streams);
    EXPECT_EQ(run({"nonsense"}, streams).code, 2) << text_of(streams);
  }
}

TEST_F(Streaming, CommandsWhoseSensePrintingIsFailWithoutIt) {
  write("a.lua", test::scene + "s:record { 'a.h5', every = 1*us } s:run(1*us)");
  ASSERT_EQ(run({"run", "a.lua"}, {}).code, 0);
  const std::vector<std::vector<std::string>> commands{
      {"info"},           {"info", "--json"},         {"--version"},     {"--help"},
      {"run", "-h"},      {"run", "a.lua", "--help"}, {"docs", "--man"}, {"docs", "--markdown"},
      {"check", "a.lua"}, {"run", "a.lua", "--json"}, {"new", "b.lua"},  {"render", "out/a/a.h5"}};
  for (const auto& command : commands)
    for (const Stream out : broken) {
      fs::remove(folder_.path / "b.lua");
      const Streams streams{Stream::usual, out, Stream::usual};
      EXPECT_EQ(run(command, streams).code, 5) << command.front() << " " << text_of(streams);
    }
}

TEST_F(Streaming, APromptWithoutInputEnds) {
  for (const Stream err : all_outputs)
    EXPECT_EQ(run({}, {Stream::closed, Stream::usual, err}).code, 0) << text_of({err});
}

TEST_F(Streaming, WhatIsReadFromNothingIsTheEnd) {
  write("a.lua", "assert(io.read('a') == nil or io.read('a') == '')");
  EXPECT_EQ(run({"run", "a.lua"}, {Stream::closed, Stream::usual, Stream::usual}).code, 0);
}

}  // namespace
}  // namespace hackle
