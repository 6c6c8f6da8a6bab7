// SPDX-License-Identifier: MIT
// libedit is C: exceptions thrown between two keys must not pass through it.
#include "console/prompt/line_editor.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/folder.hpp"

namespace hackle {
namespace {

// Returns the output of the dialogue in a separate terminal, in which `keys` are typed once it has
// shown `before`.
template <class Dialogue>
std::string in_terminal(const std::string& before, const std::string& keys, Dialogue dialogue) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    dialogue();
    std::fflush(stdout);
    _exit(0);
  }
  std::string shown;
  std::array<char, 256> part{};
  bool typed = keys.empty();
  for (ssize_t count; (count = read(terminal, part.data(), part.size())) > 0;) {
    shown.append(part.data(), static_cast<std::size_t>(count));
    if (!typed && shown.find(before) != std::string::npos)
      typed = write(terminal, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size());
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << shown;
  close(terminal);
  return shown;
}

TEST(LineEditor, WhatIsThrownBetweenKeysComesOutOfRead) {
  const std::string shown = in_terminal("", "", [] {
    LineEditor editor({});
    std::string line;
    try {
      editor.read("> ", line, [](const MakeRoom&) -> bool { throw std::runtime_error("lost"); });
    } catch (const std::runtime_error& error) {
      std::printf("caught %s", error.what());
    }
  });
  EXPECT_THAT(shown, testing::HasSubstr("caught lost"));
}

TEST(LineEditor, GoesOnAfterwards) {
  const std::string shown = in_terminal("caught", "1 + 1\n", [] {
    LineEditor editor({});
    std::string line;
    const Idle failing = [](const MakeRoom&) -> bool { throw 1; };
    EXPECT_THROW(editor.read("> ", line, failing), int);
    std::printf("caught\n");
    std::fflush(stdout);
    editor.read("> ", line, {});
    std::printf("read [%s]", line.c_str());
  });
  EXPECT_THAT(shown, testing::HasSubstr("read [1 + 1]"));
}

TEST(LineEditor, ACompleterThatThrowsIsABeep) {
  const std::string shown = in_terminal("> ", "x\ty\n", [] {
    LineEditor editor({});
    editor.complete_with([](const std::string&) -> Completion { throw 1; });
    std::string line;
    editor.read("> ", line, {});
    std::printf("read [%s]", line.c_str());
  });
  EXPECT_THAT(shown, testing::HasSubstr("read [x"));
}

}  // namespace
}  // namespace hackle
