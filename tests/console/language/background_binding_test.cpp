// SPDX-License-Identifier: MIT
// Background runs of the prompt, and the script that repeats them.
#include "console/language/background_binding.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string live_scene = R"(
p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
for edge, sign in pairs { top = 1, bottom = -1 } do
  p:traction { edge = edge, stress = {0, sign*12*MPa} }
  p:nofail { edge = edge, depth = 4*mm }
end
s = simulate(p, { spacing = 1*mm })
)";

std::string after_start(const std::string& text) {
  return test::message_of(live_scene + text);
}

TEST(Background, AStartedRunGivesTheBitsOfARun) {
  EXPECT_EQ(after_start("t = s:fork()\n"
                        "s:start(15*us) s:wait { steps = 3 } assert(s.steps == 3)\n"
                        "s:wait { steps = 9 } s:pause() s:start(5*us) s:wait()\n"
                        "t:run(20*us) assert(s.hash == t.hash and s.time == t.time)\n"
                        "s:run(0.3*us) t:run(0.3*us) assert(s.hash == t.hash)"),
            "");
}

TEST(Background, AScriptThatEndsWaitsForIt) {
  Console console(test::quiet());
  console.run_text(live_scene + "s:start(5*us)", "test.lua");
  EXPECT_DOUBLE_EQ(console.simulations().front().time, 5e-6);
}

TEST(Background, StatusSaysWhatIsGoingOn) {
  EXPECT_EQ(
      after_start("local function is(state) assert(s:status().state == state) end\n"
                  "is 'idle' s:start(5*us) is 'running' s:pause() is 'paused'\n"
                  "s:resume() is 'running' s:stop() is 'idle'\n"
                  "s:start(5*us) s:wait() is 'idle'\n"
                  "local now = s:status()\n"
                  "assert(now.steps == s.steps and now.time == s.time and now.broken_bonds == 0)"),
      "");
}

TEST(Background, WhatNeedsTheEndOfTheRunIsRefusedBefore) {
  for (const char* call : {"s:step(1)", "s:relax()", "s:rewind(s)",
                           "s:quasistatic { duration = 1*us, increments = 2 }"})
    EXPECT_THAT(after_start(std::string("s:start(5*us) ") + call),
                HasSubstr("a run is under way until"))
        << call;
}

TEST(Background, AForkStandsStill) {
  EXPECT_EQ(after_start("s:start(5*us) t = s:fork() assert(t:status().state == 'idle')\n"
                        "s:wait() assert(t.steps == 0)"),
            "");
}

TEST(Background, LoadsChangeBetweenTwoStepsUntilTheEndOfTheRun) {
  EXPECT_EQ(after_start("s:start(20*us) s:wait { steps = 10 }\n"
                        "s:traction { edge = 'top', stress = {0, 12*MPa}, time = function(t)\n"
                        "  return 1 - t/(40*us) end }\n"
                        "s:wait() assert(s.time >= 20*us)"),
            "");
}

TEST(Background, AnErrorInAFunctionEndsIt) {
  EXPECT_THAT(
      after_start("s:on { 'every', every = 2*us, call = function(t)\n"
                  "  if t > 3*us then error 'enough' end end }\n"
                  "s:start(20*us)\n"
                  "local ok, e = pcall(s.wait, s) assert(not ok and s:status().state == 'idle')\n"
                  "error(e)"),
      HasSubstr("enough"));
}

TEST(Background, SimulationsAreFoundByNumber) {
  EXPECT_EQ(after_start("t = s:fork() local all = simulations()\n"
                        "assert(all[1] == s and all[2] == t and #all == 2)"),
            "");
}

// Enters lines at a prompt; the current run continues for a moment between two of them.
struct Dialogue {
  explicit Dialogue(const test::Folder& folder) : console(test::quiet(folder.path)) {
    for (const char* line : {"p = plate { width = 100*mm, height = 40*mm, material = 'duran50' }",
                             "p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }",
                             "for edge, sign in pairs { top = 1, bottom = -1 } do\n"
                             "  p:traction { edge = edge, stress = {0, sign*12*MPa} }\n"
                             "  p:nofail { edge = edge, depth = 4*mm }\nend",
                             "s = simulate(p, { spacing = 1*mm })"})
      type(line);
  }

  std::string type(const std::string& line) {
    try {
      const auto values = console.evaluate(line);
      return values.empty() ? "" : values.front();
    } catch (const Error& error) {
      return error.what();
    }
  }
  std::string hash() { return type("s.hash"); }
  // About one step.
  std::vector<std::string> work() {
    return console.work(1e-9, [this] { ++room; });
  }

  Console console;
  int room = 0;
};

// Returns the hash of simulation 1 at the end of a script.
std::string hash_after(const std::filesystem::path& script, const test::Folder& folder) {
  Console console(test::quiet(folder.path / "again"));
  console.run_file(script);
  return console.simulations().front().hash;
}

TEST(Script, DoesAgainWhatWasTypedWhileItRan) {
  const test::Folder folder;
  Dialogue dialogue(folder);
  dialogue.type("s:start(30*us)");
  for (int k = 0; k < 20; ++k) dialogue.work();
  dialogue.type("local top = 8*MPa s:traction { edge = 'top', stress = {0, top} }");
  dialogue.work();
  dialogue.type("s:nonsense()");
  dialogue.work();
  dialogue.type("(s):damping { rate = 1e4 }");
  dialogue.work();
  dialogue.type("return 5");
  dialogue.type("nothing");
  dialogue.type("=s.energy");
  dialogue.type("s:script { 'typed.lua' }");
  const std::string hash = dialogue.hash();
  EXPECT_EQ(dialogue.type("s:status().state"), "running");
  EXPECT_EQ(hash_after(folder.path / "typed.lua", folder), hash);
}

TEST(Script, StopsWhereCtrlCStopped) {
  const test::Folder folder;
  Dialogue dialogue(folder);
  dialogue.type("s:on { 'every', every = 7*us, call = function(t) if t > 0 then hit() end end }");
  dialogue.type("function hit() end");
  request_interrupt();
  EXPECT_THAT(dialogue.type("s:run(30*us)"), HasSubstr("interrupted"));
  clear_interrupt();
  dialogue.type("s:run(5*us)");
  request_interrupt();
  dialogue.type("while true do end");
  clear_interrupt();
  dialogue.type("s:script { 'typed.lua' }");
  const std::string hash = dialogue.hash();
  EXPECT_EQ(hash_after(folder.path / "typed.lua", folder), hash);
  EXPECT_THAT(read_text(folder.path / "typed.lua"), HasSubstr("-- interrupted, and left out:"));
}

TEST(Script, OfAScriptIsTheScript) {
  const test::Folder folder;
  const std::string script = test::scene + "s:run(1*us) s:script { 'same.lua' }";
  Console console(test::quiet(folder.path));
  console.run_text(script, "test.lua");
  EXPECT_EQ(read_text(folder.path / "same.lua"), script);
}

TEST(Prompt, WorksBetweenTheLinesUntilItHasArrived) {
  const test::Folder folder;
  Dialogue dialogue(folder);
  EXPECT_FALSE(dialogue.console.is_working());
  dialogue.type("s:start(3*us)");
  std::vector<std::string> news;
  while (dialogue.console.is_working())
    for (const std::string& one : dialogue.work()) news.push_back(one);
  EXPECT_THAT(news, ElementsAre("simulation 1 has arrived"));
}

TEST(Prompt, MakesRoomForWhatIsPrintedMeanwhile) {
  const test::Folder folder;
  Dialogue dialogue(folder);
  dialogue.type("s:on { 'break', call = function() print() end }");
  dialogue.type("s:start(30*us)");
  testing::internal::CaptureStdout();
  while (dialogue.console.is_working()) dialogue.work();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "\n");
  EXPECT_EQ(dialogue.room, 1);
}

TEST(Prompt, PausesAllThatIsUnderWay) {
  const test::Folder folder;
  Dialogue dialogue(folder);
  dialogue.type("s:start(3*us)");
  dialogue.type("t = s:fork()");
  dialogue.type("t:start(3*us)");
  dialogue.console.pause_work();
  EXPECT_FALSE(dialogue.console.is_working());
  EXPECT_EQ(dialogue.type("s:status().state"), "paused");
  dialogue.type("s:resume()");
  EXPECT_TRUE(dialogue.console.is_working());
  EXPECT_EQ(dialogue.type("t:status().state"), "paused");
}

TEST(Prompt, WhatNobodyHoldsGoesOnUntilItHasArrived) {
  const test::Folder folder;
  Dialogue dialogue(folder);
  dialogue.type("s:fork():start(3*us)");
  dialogue.type("_ = nil collectgarbage()");
  while (dialogue.console.is_working()) dialogue.work();
  EXPECT_GE(dialogue.console.simulations().back().time, 3e-6);
}

}  // namespace
}  // namespace hackle
