// SPDX-License-Identifier: MIT
// The lines of a newcomer, and the response of the terminal.
#include "terminal/terminal.hpp"

namespace hackle {
namespace {

class Dialogue : public test::TerminalTest {};

TEST_F(Dialogue, ANewcomerBreaksAPlate) {
  test::Terminal terminal(80, 24);
  terminal.expect("help() tells more, Ctrl-D leaves\n>");
  terminal.say("help()");
  terminal.expect("These lines break one");
  terminal.say("p = plate { width = 100*mm, height = 40*mm, material = \"duran50\" }");
  terminal.say("p");
  terminal.expect("plate 100 x 40 mm, Duran 50 glass");
  terminal.say("p:crck { from = {0, 20*mm}, to = {50*mm, 20*mm} }");
  terminal.expect("error: plate has no 'crck' (did you mean 'crack'?)");
  terminal.say("p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }");
  terminal.say("p:traction { edge = \"top\", stres = {0, 12*MPa} }");
  terminal.expect("did you mean 'stress'?");
  terminal.say("p:traction { edge = \"top\", stress = {0, 12*MPa} }");
  terminal.say("p:traction { edge = \"bottom\", stress = {0, -12*MPa} }");
  terminal.say("s = simulate(p, { spacing = 1*mm })");
  terminal.say("s:run(20*us)");
  terminal.say("s");
  terminal.expect("4 000 nodes, 90 454 bonds");
  terminal.expect("; at 20");
  terminal.say("s.energy");
  terminal.expect("kinetic = ");
  terminal.say("s.damage.broken_bonds > 0");
  terminal.expect("\ntrue\n>");
}

TEST_F(Dialogue, ValuesAreShownAndRemembered) {
  test::Terminal terminal(80, 24);
  terminal.say("{ 1, 2, x = \"a\" }");
  terminal.expect("\n{1, 2, x = \"a\"}\n>");
  terminal.say("6 * 7");
  terminal.say("_ + 1");
  terminal.expect("\n43\n>");
  terminal.say("local a = 1");
  terminal.say("a + 1");
  terminal.expect("\n2\n>");
}

TEST_F(Dialogue, TheUpKeyBringsLinesBack) {
  test::Terminal terminal(80, 24);
  terminal.say("x = 41");
  terminal.say("x + 1");
  terminal.press("Up");
  terminal.expect_last("> x + 1");
  terminal.press("Up");
  terminal.expect_last("> x = 41");
}

TEST_F(Dialogue, AChunkGoesOnOverLines) {
  test::Terminal terminal(80, 24);
  terminal.expect_last(">");
  terminal.enter("for i = 1, 3 do");
  terminal.expect_last(">>");
  terminal.enter("  print(\"line \" .. i)");
  terminal.enter("end");
  terminal.expect("line 1\nline 2\nline 3\n>");
}

TEST_F(Dialogue, CtrlCDropsTheLineAndCtrlDLeaves) {
  test::Terminal terminal(80, 24);
  terminal.expect_last(">");
  terminal.type("never said");
  terminal.expect_last("> never said");
  terminal.press("C-c");
  terminal.expect("> never said^C\n>");
  terminal.say("1 + 1");
  terminal.expect("\n2\n>");
  terminal.press("C-d");
  terminal.expect("left with 0");
}

TEST_F(Dialogue, ErrorsAreInColour) {
  test::Terminal terminal(80, 24);
  terminal.say("plate { widht = 1*mm }");
  const std::string screen = terminal.painted();
  EXPECT_NE(screen.find("\033[1m\033[31merror:"), std::string::npos) << screen;
}

}  // namespace
}  // namespace hackle
