// SPDX-License-Identifier: MIT
// None of these scripts ends by itself: a failure shows as a test that takes too long.
#include "console/interrupt_hook.hpp"

#include <gmock/gmock.h>

#include "base/interrupt.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

class InterruptHook : public testing::Test {
 protected:
  ~InterruptHook() override { clear_interrupt(); }

  static void expect_interrupted(const std::string& script) {
    request_interrupt();
    const auto failure = test::failure_of(script, test::quiet());
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->kind(), ErrorKind::interrupted) << failure->what();
    clear_interrupt();
  }
};

TEST_F(InterruptHook, StopsALoopOfLua) {
  expect_interrupted("while true do end");
}

TEST_F(InterruptHook, StopsALoopThatCatchesEveryError) {
  expect_interrupted("while true do pcall(function() while true do end end) end");
}

TEST_F(InterruptHook, StopsACoroutineAndWhoWaitsForIt) {
  expect_interrupted("while true do pcall(coroutine.wrap(function() while true do end end)) end");
}

TEST_F(InterruptHook, StopsAScriptThatCatchesAnInterruptedRun) {
  expect_interrupted(test::scene + "while true do pcall(s.run, s, 1) end");
}

TEST_F(InterruptHook, TheNextScriptRunsAgain) {
  expect_interrupted("while true do end");
  EXPECT_EQ(test::message_of("for i = 1, 100000 do end"), "");
}

TEST_F(InterruptHook, OsExitEndsAScriptThatCatchesEveryError) {
  Console console(test::quiet());
  console.run_text("while true do pcall(os.exit, 7) end", "test.lua");
  EXPECT_EQ(console.exit_code(), 7);
}

}  // namespace
}  // namespace hackle
