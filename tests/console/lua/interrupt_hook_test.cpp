// SPDX-License-Identifier: MIT
// None of these scripts ends by itself: a failure shows as a test that takes too long.
#include "console/lua/interrupt_hook.hpp"

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

TEST_F(InterruptHook, StopsALoopOfCallsThatAreCaught) {
  expect_interrupted("while true do pcall(plate) end");
}

TEST_F(InterruptHook, AHandlerOfErrorsIsNotAskedAboutIt) {
  expect_interrupted("xpcall(function() while true do end end, function() while true do end end)");
  expect_interrupted(
      "while true do xpcall(function() while true do end end, function() return 1 end) end");
}

TEST_F(InterruptHook, VariablesOfAStoppedCoroutineAreNotClosed) {
  const std::string closing =
      "local x <close> = setmetatable({}, { __close = function() while true do end end })\n";
  expect_interrupted("coroutine.wrap(function() " + closing + " while true do end end)()");
  expect_interrupted("local c = coroutine.create(function() " + closing +
                     " while true do end end) coroutine.resume(c) coroutine.close(c)");
  expect_interrupted(closing + "while true do end");
}

TEST_F(InterruptHook, OtherErrorsAreHandledAndYieldedAsEver) {
  EXPECT_EQ(test::message_of(R"(
    local ok, what = xpcall(error, function(e) return e .. '!' end, 'no')
    assert(not ok and what == 'no!')
    assert(select('#', xpcall(function(...) return ... end, print, 1, nil, nil)) == 4)
    assert(not pcall(xpcall, error) and not pcall(coroutine.wrap))
    local f = coroutine.wrap(function(a)
      local ok, b = xpcall(function() return coroutine.yield(a + 1) end, print)
      return ok, b, 'end'
    end)
    assert(f(1) == 2)
    local ok, b, last = f(5)
    assert(ok and b == 5 and last == 'end')
    ok, what = pcall(f)
    assert(not ok and what:find 'dead')
    local closed
    f = coroutine.wrap(function()
      local x <close> = setmetatable({}, { __close = function() closed = true end })
      error 'fell'
    end)
    ok, what = pcall(f)
    assert(not ok and what:find 'fell' and closed)
    ok, what = pcall(coroutine.wrap(function() error { 7 } end))
    assert(what[1] == 7))"),
            "");
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
