// SPDX-License-Identifier: MIT
// hackle check, hackle new, and the options of a script in its help.
#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class CheckTest : public testing::Test {
 protected:
  test::Ended run(const std::string& command, const std::string& script,
                  const std::vector<std::string>& words = {}) {
    write_text(folder_.path / "a.lua", script);
    std::vector<std::string> all{command, "a.lua"};
    all.insert(all.end(), words.begin(), words.end());
    return program_.run(all);
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(CheckTest, TellsWhatAScriptTakesAndWritesNothing) {
  const auto ended = run("check", test::scene + R"(
    s:movie { "a.mp4", every = 1*us } s:record { "a.h5", every = 1*us } s:frame { "a.png" }
    for k = 1, 3 do s:run(10*us) end
    print "results" s:relax()
    assert(s.time >= 30*us))");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 000 nodes, 21 254 bonds"));
  EXPECT_THAT(ended.out, HasSubstr("30 us in 36 steps of 833.3 ns"));
  EXPECT_THAT(ended.out, HasSubstr("it should break"));
  EXPECT_THAT(ended.out, Not(HasSubstr("results")));
  EXPECT_FALSE(fs::exists(folder_.path / "out"));
}

// Loads that were removed again, quasi-static loading, functions that may change everything.
TEST_F(CheckTest, JudgesTheWholeScript) {
  const auto verdict = [&](const std::string& more) {
    const auto ended = run("check", R"(
      local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
      p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
      local s = simulate(p, { spacing = 2*mm })
      local function pull(stress, time)
        s:traction { edge = "top", stress = {0, stress}, time = time }
        s:traction { edge = "bottom", stress = {0, -stress}, time = time }
      end
      )" + more);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out;
  };
  EXPECT_THAT(verdict("s:run(10*us)"), HasSubstr("nothing can break"));
  EXPECT_THAT(verdict("pull(24*MPa) s:run(30*us) pull(0) s:run(1*us)"), HasSubstr("should break"));
  EXPECT_THAT(verdict("pull(24*MPa, ramp(1)) s:quasistatic { duration = 1, increments = 4 }"),
              testing::AllOf(HasSubstr("should break"), HasSubstr("slow loading in 4 increments")));
  EXPECT_THAT(verdict("pull(6*MPa) s:relax() pull(0) s:run(10*us)"), HasSubstr("may break"));
  EXPECT_THAT(verdict("s:move { edge = 'top', depth = 4*mm, velocity = {0, 1} } s:run(1*ms)"),
              HasSubstr("should break"));
  EXPECT_THAT(verdict("s:run(5*us) t = s:fork() pull(24*MPa) s:run(9*us)"),
              testing::ContainsRegex("should break(.|\n)*simulation 2(.|\n)*nothing can break"));
  const std::string called =
      verdict("s:on { 'every', every = 1*us, call = function() pull(24*MPa) end } s:run(10*us)");
  EXPECT_THAT(called, HasSubstr("unknown: a function that s:on calls may change loads"));
  EXPECT_THAT(called, Not(HasSubstr("nothing can break")));
  EXPECT_THAT(verdict("s:run(1*us) if s.damage.broken_bonds > 0 then pull(24*MPa) end s:run(1*us)"),
              HasSubstr("unknown: what the script does after it has looked at results"));
}

TEST_F(CheckTest, TellsOfEverySimulation) {
  const auto ended = run("check", test::scene + "t = s:fork() s:run(1*us) t:start(2*us)");
  EXPECT_THAT(ended.out, testing::ContainsRegex("simulation 1(.|\n)*in 2 steps(.|\n)*"
                                                "simulation 2(.|\n)*in 3 steps"));
}

TEST_F(CheckTest, FindsWhatARunWouldFind) {
  EXPECT_EQ(run("check", "plate { width = -1 }").code, 4);
  EXPECT_EQ(run("check", "x =").code, 3);
  EXPECT_EQ(run("check", "error 'no'").code, 3);
  EXPECT_EQ(run("check", test::scene + "s:movie { 'a.mp4', every = -1*ns }").code, 4);
  EXPECT_EQ(run("check", test::scene, {"--set", "nonsense=1"}).code, 4);
}

TEST_F(CheckTest, AScriptThatWantsResultsIsNoFailure) {
  const auto ended =
      run("check", test::scene + "s:run(1*us) assert(s.damage.broken_bonds > 0, 'none broke')");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the script then needs results: a.lua:7: none broke"));
}

TEST_F(CheckTest, AScriptThatWaitsForResultsEnds) {
  const auto ended = run("check", test::scene + "while s.damage.broken_bonds == 0 do s:run(1) end");
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("there is no end"));
}

TEST_F(CheckTest, HelpOnAScriptListsItsOptions) {
  const auto ended =
      run("run", "local o = options { load = 12*MPa, film = true } error 'not run'", {"--help"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("--threads"));
  EXPECT_THAT(ended.out, HasSubstr("Options of a.lua, for --set:\n  film = true\n  load = 12*MPa"));
  EXPECT_THAT(run("run", test::scene + "s:run(1)", {"-h"}).out, HasSubstr("a.lua has no options"));
}

TEST_F(CheckTest, ANewScriptRuns) {
  EXPECT_EQ(program_.run({"new", "mine"}).code, 0);
  EXPECT_EQ(program_.run({"check", "mine.lua"}).code, 0);
  const auto ended = program_.run({"run", "mine.lua", "--set", "spacing=1*mm", "-q"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder_.path / "out/mine/broken.png"));
  EXPECT_TRUE(fs::exists(folder_.path / "out/mine/breaks.mp4"));
}

TEST_F(CheckTest, ANewScriptIsWrittenOverNothing) {
  write_text(folder_.path / "mine.lua", "precious");
  EXPECT_EQ(program_.run({"new", "mine"}).code, 5);
  EXPECT_EQ(read_text(folder_.path / "mine.lua"), "precious");
}

}  // namespace
}  // namespace hackle
