// SPDX-License-Identifier: MIT
// Tab in a terminal; tests/console tests the candidates.
#include "terminal/terminal.hpp"

namespace hackle {
namespace {

class Tab : public test::TerminalTest {};

TEST_F(Tab, CompletesTheOnlyCandidate) {
  test::Terminal terminal(80, 24);
  terminal.expect_last(">");
  terminal.type("pla");
  terminal.press("Tab");
  terminal.expect_last("> plate {");
  terminal.type("wi");
  terminal.press("Tab");
  terminal.expect_last("> plate { width =");
  terminal.type("1*mm, material = \"dur");
  terminal.press("Tab");
  terminal.expect_last("> plate { width = 1*mm, material = \"duran50\"");
}

TEST_F(Tab, TwiceShowsTheCandidatesAndTheLineAgain) {
  test::Terminal terminal(80, 24);
  terminal.expect_last(">");
  terminal.type("string.re");
  terminal.press("Tab");
  terminal.press("Tab");
  terminal.expect("> string.re\nrep      reverse\n> string.re");
  terminal.type("v");
  terminal.press("Tab");
  terminal.expect_last("> string.reverse(");
}

TEST_F(Tab, KnowsTheLinesBefore) {
  test::Terminal terminal(80, 24);
  terminal.expect_last(">");
  terminal.enter("plate { width = 10*mm,");
  terminal.expect_last(">>");
  terminal.type("he");
  terminal.press("Tab");
  terminal.expect_last(">> height =");
}

TEST_F(Tab, IsABlankInWhatIsPasted) {
  test::Terminal terminal(80, 24);
  terminal.expect_last(">");
  terminal.enter("x = {\n\t4,\n\t5 }");
  terminal.say("#x");
  terminal.expect("\n2\n>");
}

}  // namespace
}  // namespace hackle
