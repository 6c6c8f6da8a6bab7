// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <array>

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr std::array<std::string_view, 4> words{"crack", "traction", "nofail", "width"};

TEST(Nearest, FindsSlipsOfTheFinger) {
  EXPECT_EQ(nearest("crck", words), "crack");
  EXPECT_EQ(nearest("tracton", words), "traction");
  EXPECT_EQ(nearest("widht", words), "width");
  EXPECT_EQ(nearest("crack", words), "crack");
}

TEST(Nearest, FindsWhatGoesOn) {
  EXPECT_EQ(nearest("trac", words), "traction");
  EXPECT_FALSE(nearest("tra", words));
}

TEST(Nearest, SaysNothingRatherThanMislead) {
  EXPECT_FALSE(nearest("pressure", words));
  EXPECT_FALSE(nearest("", words));
  EXPECT_FALSE(nearest("x", {}));
}

TEST(DidYouMean, IsReadyForAMessage) {
  EXPECT_EQ(did_you_mean("crck", words), " (did you mean 'crack'?)");
  EXPECT_EQ(did_you_mean("pressure", words), "");
}

TEST(CommaList, JoinsWords) {
  EXPECT_EQ(comma_list(words), "crack, traction, nofail, width");
  EXPECT_EQ(comma_list({}), "");
}

TEST(Hanging, BreaksAtBlanksAndIndents) {
  EXPECT_EQ(hanging("one two three", 0, 80), "one two three");
  EXPECT_EQ(hanging("one two three", 2, 9), "one two\n  three");
  EXPECT_EQ(hanging("immeasurable it is", 2, 8), "immeasurable\n  it is");
  EXPECT_EQ(hanging("", 2, 8), "");
}

TEST(Fitted, BreaksWideLinesAndKeepsTheOthers) {
  EXPECT_EQ(fitted("a\n  one two three\n\nb\n", 9), "a\n  one two\n  three\n\nb\n");
  EXPECT_EQ(fitted("one two three", 80), "one two three");
  EXPECT_EQ(fitted("", 9), "");
  EXPECT_EQ(fitted("\n\n", 9), "\n\n");
  EXPECT_EQ(fitted("     deep", 10), "     deep");
}

// What begins beyond the middle would be broken after every word.
TEST(Fitted, MovesDeepLinesToTheLeft) {
  EXPECT_EQ(fitted("         deep", 10), "  deep");
  EXPECT_EQ(fitted("         a deeper line", 12), "   a deeper\n   line");
}

TEST(ShellWord, IsQuotedWhereAShellWouldTakeItApart) {
  EXPECT_EQ(shell_word("out/edge_crack.h5"), "out/edge_crack.h5");
  EXPECT_EQ(shell_word("my run.h5"), "'my run.h5'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("$HOME"), "'$HOME'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace hackle
