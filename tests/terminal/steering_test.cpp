// SPDX-License-Identifier: MIT
// Background runs while a person types, in a real terminal.
#include "terminal/terminal.hpp"

namespace hackle {
namespace {

class Steering : public test::TerminalTest {
 protected:
  void SetUp() override {
    TerminalTest::SetUp();
    if (IsSkipped()) return;
    terminal_.say("p = plate { width = 100*mm, height = 40*mm, material = 'duran50' }");
    terminal_.say("p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }");
    terminal_.say("p:traction { edge = 'top', stress = {0, 12*MPa} }");
    terminal_.say("p:traction { edge = 'bottom', stress = {0, -12*MPa} }");
  }

  test::Terminal terminal_{100, 40};
};

TEST_F(Steering, WhatIsTypedStaysThereWhileARunSpeaks) {
  terminal_.say("s = simulate(p, { spacing = 0.5*mm })");
  terminal_.say("s:on { 'every', every = 10*us, call = function(t) print('now', t) end }");
  terminal_.expect_last(">");
  terminal_.enter("s:start(35*us)");
  terminal_.type("s.steps >");
  terminal_.expect("note: simulation 1 has arrived\n> s.steps >");
  terminal_.enter(" 0");
  terminal_.expect("\ntrue\n>");
  terminal_.expect("now     0.0\n");
}

TEST_F(Steering, CtrlCOnAnEmptyLinePauses) {
  terminal_.say("s = simulate(p, { spacing = 0.25*mm })");
  terminal_.say("s:start(1)");  // for minutes
  terminal_.say("s:status().state");
  terminal_.expect("\nrunning\n");
  terminal_.press("C-c");
  terminal_.expect("note: paused; s:resume() continues\n>");
  terminal_.say("s:status().state");
  terminal_.expect("\npaused\n");
  terminal_.say("steps = s.steps");
  terminal_.say("steps > 0 and steps == s.steps");
  terminal_.expect("\ntrue\n>");
  terminal_.press("C-d");
  terminal_.expect("left with 0");
}

TEST_F(Steering, AWatchedRunIsDrawnInOnePlace) {
  terminal_.say("s = simulate(p, { spacing = 1*mm })");
  terminal_.say("s:watch { every = 2*us }");
  terminal_.expect_last(">");
  terminal_.enter("s:start(20*us)");
  terminal_.expect("has arrived");
  const std::string screen = terminal_.shown();
  EXPECT_NE(screen.find("damage at 20"), std::string::npos) << screen;
  EXPECT_EQ(screen.find("damage at"), screen.rfind("damage at")) << screen;
}

}  // namespace
}  // namespace hackle
