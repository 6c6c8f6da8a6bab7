// SPDX-License-Identifier: MIT
#include "console/prompt/line_reader.hpp"

#include <thread>

#include <gmock/gmock.h>
#include <unistd.h>

namespace hackle {
namespace {

using testing::ElementsAre;

// Replaces stdin by a pipe.
class Pipe {
 public:
  Pipe() : stdin_(dup(STDIN_FILENO)) {
    EXPECT_EQ(pipe(ends_), 0);
    dup2(ends_[0], STDIN_FILENO);
    close(ends_[0]);
  }
  ~Pipe() {
    finish();
    dup2(stdin_, STDIN_FILENO);
    close(stdin_);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void write(const std::string& text) {
    EXPECT_EQ(::write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void finish() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int stdin_;
  int ends_[2] = {-1, -1};
};

std::vector<std::string> lines_of(const std::string& text) {
  Pipe pipe;
  pipe.write(text);
  pipe.finish();
  LineReader reader;
  std::vector<std::string> lines;
  std::string line;
  while (reader.read(line, [](const MakeRoom&) { return false; }) == LineEnd::entered)
    lines.push_back(line);
  return lines;
}

TEST(LineReader, TakesTextApart) {
  EXPECT_THAT(lines_of(""), ElementsAre());
  EXPECT_THAT(lines_of("a"), ElementsAre("a"));
  EXPECT_THAT(lines_of("a\nb\r\n\nc"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(lines_of("\n"), ElementsAre(""));
  EXPECT_THAT(lines_of(std::string(10000, 'x') + "\ny\n"),
              ElementsAre(std::string(10000, 'x'), "y"));
}

TEST(LineReader, HasOthersWorkUntilALineIsThere) {
  Pipe pipe;
  LineReader reader;
  std::string line;
  int turns = 0;
  const Idle idle = [&](const MakeRoom&) {
    if (++turns == 3) pipe.write("one\ntwo\n");
    return true;
  };
  EXPECT_EQ(reader.read(line, idle), LineEnd::entered);
  EXPECT_EQ(line, "one");
  EXPECT_EQ(turns, 3);
  EXPECT_EQ(reader.read(line, idle), LineEnd::entered);
  EXPECT_EQ(line, "two");
  EXPECT_EQ(turns, 3);
}

}  // namespace
}  // namespace hackle
