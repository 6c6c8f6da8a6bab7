// SPDX-License-Identifier: MIT
// The prompt in a real terminal, provided by tmux: sends keys and reads the screen.
#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/text.hpp"
#include "support/folder.hpp"
#include "support/skipping.hpp"

namespace hackle::test {

// Returns the output of a shell command.
inline std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  char block[4096];
  for (std::size_t count = 0; (count = std::fread(block, 1, sizeof block, pipe)) > 0;)
    text.append(block, count);
  pclose(pipe);
  return text;
}

inline bool has_tmux() {
  return !output_of("command -v tmux").empty();
}

// A terminal with its own tmux server, in which hackle runs in an empty folder. When hackle ends,
// the terminal shows "left with <code>".
class Terminal {
 public:
  Terminal(int columns, int lines) : socket_((folder_.path / "tmux").string()) {
    const std::string folder = shell_word(folder_.path.string());
    const std::string program = fmt::format(
        "trap : INT; cd {0} && env HOME={0} XDG_STATE_HOME={0}/state {1} {2}; echo left with $?; "
        "sleep 600",
        folder, "TERM=screen-256color", shell_word(HACKLE_PROGRAM));
    tmux(fmt::format("-f /dev/null new-session -d -x {} -y {} {}", columns, lines,
                     shell_word(program)));
  }
  ~Terminal() { tmux("kill-server"); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  // Types text as on the keyboard; a semicolon at the end is lost.
  void type(const std::string& text) { tmux("send-keys -l -- " + shell_word(text)); }
  // Presses a key by tmux's name: Enter, Tab, Up, C-c.
  void press(const std::string& key) { tmux("send-keys " + key); }
  void enter(const std::string& line) {
    type(line);
    press("Enter");
  }

  // Returns everything shown so far, without blanks at the ends of lines.
  std::string shown() const { return tmux("capture-pane -p -J -S - | sed 's/ *$//'"); }
  // Returns it with escape sequences for colours.
  std::string painted() const { return tmux("capture-pane -p -e -S -"); }

  // Waits until the text is shown; fails the test if it does not appear in time.
  void expect(const std::string& text) {
    EXPECT_TRUE(waits([&] { return shown().find(text) != std::string::npos; }))
        << "never shown: " << text << "\n"
        << shown();
  }
  // Waits until this is the last line.
  void expect_last(const std::string& line) {
    EXPECT_TRUE(waits([&] { return last_line() == line; }))
        << "the last line is never '" << line << "'\n"
        << shown();
  }
  // Enters a line at the prompt and waits for the prompt to return.
  void say(const std::string& line) {
    expect_last(">");
    const std::string before = shown();
    type(line);
    expect(line);
    press("Enter");
    EXPECT_TRUE(waits([&] { return shown() != before && last_line() == ">"; })) << shown();
  }

 private:
  template <class Condition>
  bool waits(Condition holds) const {
    // Half a minute; after a failure there is no need to wait.
    const int tries = testing::Test::HasFailure() ? 1 : 600;
    for (int i = 0; i < tries; ++i) {
      const bool ended = last_line().starts_with("left with");
      if (holds()) return true;
      if (ended) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  std::string tmux(const std::string& words) const {
    return output_of(fmt::format("tmux -S {} 2>/dev/null {}", shell_word(socket_), words));
  }

  std::string last_line() const {
    std::string text = shown();
    while (text.ends_with('\n')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
  }

  Folder folder_;
  std::string socket_;
};

class TerminalTest : public testing::Test {
 protected:
  void SetUp() override { HACKLE_NEEDS(has_tmux(), "tmux is not installed"); }
};

}  // namespace hackle::test
