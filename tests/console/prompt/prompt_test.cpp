// SPDX-License-Identifier: MIT
#include "console/prompt/prompt.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;

// Types lines like a person; "^C" clears the line.
struct Talker {
  std::vector<std::string> lines;
  std::vector<std::string> prompts, values, errors, notes;

  int talk() {
    Console console(test::quiet());
    std::size_t next = 0;
    const auto read = [&](const std::string& prompt, std::string& line, const Idle&) {
      prompts.push_back(prompt);
      if (next == lines.size()) return LineEnd::end_of_input;
      line = lines[next++];
      return line == "^C" ? LineEnd::cleared : LineEnd::entered;
    };
    Prompt prompt(console, read,
                  {[&](const std::string& value) { values.push_back(value); },
                   [&](const Error& error) { errors.emplace_back(error.what()); },
                   [&](const std::string& note) { notes.push_back(note); }});
    return prompt.run();
  }
};

TEST(Prompt, ShowsValues) {
  Talker talker{{"x = 2", "x", "x + 1, 'a'"}, {}, {}, {}, {}};
  EXPECT_EQ(talker.talk(), 0);
  EXPECT_THAT(talker.values, ElementsAre("2", "3", "a"));
  EXPECT_THAT(talker.prompts, ElementsAre("> ", "> ", "> ", "> "));
}

TEST(Prompt, TheLastResultIsUnderscore) {
  Talker talker{{"6 * 7", "_ + 1", "nil", "x = 1", "_"}, {}, {}, {}, {}};
  EXPECT_EQ(talker.talk(), 0);
  EXPECT_THAT(talker.values, ElementsAre("42", "43", "nil", "43"));
}

// The lines of a script may be pasted: its locals last.
TEST(Prompt, LocalsStay) {
  Talker talker{{"local a = 1", "a", "local function twice(x)", "local y = 2 * x", "return y",
                 "end", "twice(a), y"},
                {},
                {},
                {},
                {}};
  EXPECT_EQ(talker.talk(), 0);
  EXPECT_THAT(talker.values, ElementsAre("1", "2", "nil"));
}

TEST(Prompt, AsksForMoreUntilTheLinesMakeSense) {
  Talker talker{{"t = {", "4,", "5}", "#t"}, {}, {}, {}, {}};
  talker.talk();
  EXPECT_THAT(talker.prompts, ElementsAre("> ", ">> ", ">> ", "> ", "> "));
  EXPECT_THAT(talker.values, ElementsAre("2"));
}

TEST(Prompt, CtrlCDropsWhatWasBegun) {
  Talker talker{{"for i = 1, 2 do", "^C", "8"}, {}, {}, {}, {}};
  EXPECT_EQ(talker.talk(), 0);
  EXPECT_THAT(talker.prompts, ElementsAre("> ", ">> ", "> ", "> "));
  EXPECT_THAT(talker.values, ElementsAre("8"));
}

TEST(Prompt, GoesOnAfterAnErrorAndReturnsTheCodeOfTheFirst) {
  Talker talker{{"plate {}", "error 'b'", "9"}, {}, {}, {}, {}};
  EXPECT_EQ(talker.talk(), 4);
  EXPECT_EQ(talker.errors.size(), 2u);
  EXPECT_THAT(talker.values, ElementsAre("9"));
}

TEST(Prompt, WhatWasNeverFinishedIsAnError) {
  Talker talker{{"f("}, {}, {}, {}, {}};
  EXPECT_EQ(talker.talk(), 3);
}

TEST(Prompt, OsExitLeaves) {
  Talker talker{{"os.exit(5)", "1"}, {}, {}, {}, {}};
  EXPECT_EQ(talker.talk(), 5);
  EXPECT_THAT(talker.values, ElementsAre());
}

TEST(Prompt, SimulationsLiveFromLineToLine) {
  Talker talker{{"p = plate { width = 20*mm, height = 20*mm, material = 'duran50' }",
                 "s = simulate(p, { spacing = 1*mm })", "s:step(2)", "s:step(3)", "s.steps"},
                {},
                {},
                {},
                {}};
  EXPECT_EQ(talker.talk(), 0);
  EXPECT_THAT(talker.values, ElementsAre("5"));
}

}  // namespace
}  // namespace hackle
