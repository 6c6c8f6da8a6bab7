// SPDX-License-Identifier: MIT
// Ctrl-C during work: the prompt returns.
#include "terminal/terminal.hpp"

namespace hackle {
namespace {

class CtrlC : public test::TerminalTest {
 protected:
  using Clock = std::chrono::steady_clock;

  // Enters a line that never ends by itself and prints "begun" first; Ctrl-C must end it soon. A
  // person expects 0.2 s; a loaded machine gets more.
  void expect_to_stop(const std::string& line) {
    terminal_.expect_last(">");
    terminal_.enter("io.write('be', 'gun\\n') io.flush() " + line);
    terminal_.expect("\nbegun\n");
    const auto pressed = Clock::now();
    terminal_.press("C-c");
    terminal_.expect("interrupted");
    terminal_.expect_last(">");
    const double seconds = std::chrono::duration<double>(Clock::now() - pressed).count();
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_LT(seconds, 5.0);
    terminal_.say("1 + 1");
    terminal_.expect("\n2\n>");
  }

  test::Terminal terminal_{100, 24};
};

TEST_F(CtrlC, EndsALoop) {
  expect_to_stop("while true do end");
}

TEST_F(CtrlC, EndsALoopThatCatchesErrors) {
  expect_to_stop("while true do pcall(error) end");
}

TEST_F(CtrlC, EndsACoroutine) {
  expect_to_stop("coroutine.wrap(function() while true do end end)()");
}

TEST_F(CtrlC, EndsARun) {
  terminal_.say("p = plate { width = 100*mm, height = 40*mm, material = 'duran50' }");
  terminal_.say("s = simulate(p, { spacing = 0.5*mm })");
  terminal_.say("s:step(1)");
  expect_to_stop("s:run(1)");
  terminal_.say("s.steps > 0");
  terminal_.expect("\ntrue\n>");
}

TEST_F(CtrlC, TwiceLeavesWhatDoesNotListen) {
  terminal_.expect_last(">");
  terminal_.enter(
      "io.write('be', 'gun\\n') io.flush() x = (('a'):rep(60)):find(('a-'):rep(60) .. 'b')");
  terminal_.expect("\nbegun\n");
  terminal_.press("C-c");
  terminal_.expect("again to abort");  // two signals at once would count as one
  terminal_.press("C-c");
  terminal_.expect("left with 130");
}

}  // namespace
}  // namespace hackle
