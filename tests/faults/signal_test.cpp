// SPDX-License-Identifier: MIT
// Signals at bad moments. Every script would run for ever or much too long: if it is not
// interrupted, the program hangs.
#include <gmock/gmock.h>

#include "base/files.hpp"
#include "faults/faulty_program.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using testing::HasSubstr;

class Signals : public testing::Test {
 protected:
  // Sends the signal shortly after the script has printed "go".
  Ended run(const std::string& script, int number, int milliseconds = 50) const {
    write_text(folder_.path / "a.lua", "print 'go' io.stdout:flush()\n" + script);
    return program_.run({"run", "a.lua"}, {.meanwhile = [&](pid_t process) {
                          program_.wait_for_go();
                          std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
                          kill(process, number);
                        }});
  }

  test::Folder folder_;
  test::FaultyProgram program_{folder_};
};

const std::string endless = test::scene +
                            "s:movie { 'a.mp4', every = 1*us, width = 320 }\n"
                            "s:record { 'a.h5', every = 1*ms }\n"
                            "s:run(1*us) print 'go' s:run(1)";

const std::string kept = test::scene +
                         "s:record { 'r.h5', every = 1*us } s:run(1*us) s:close()\n"
                         "r = recording 'out/a/r.h5'\n";

// Each does work without end; a script that catches the error must not continue.
const std::vector<std::string> endless_scripts{
    "while true do end",
    "repeat until false",
    "::again:: goto again",
    "for i = 1, math.huge do end",
    "while true do pcall(function() while true do end end) end",
    "while true do pcall(error) end",
    "xpcall(function() while true do end end, function() while true do end end)",
    "xpcall(error, function() while true do end end)",
    "while true do xpcall(error, function() xpcall(error, print) end) end",
    "while true do coroutine.wrap(function() coroutine.yield() end)() end",
    "local f = coroutine.wrap(function() while true do pcall(coroutine.yield) end end)\n"
    "while true do f() end",
    "while true do pcall(coroutine.wrap(function() while true do end end)) end",
    "local c = coroutine.create(function() local x <close> = setmetatable({}, { __close = "
    "function() while true do end end }) coroutine.yield() end)\n"
    "coroutine.resume(c) coroutine.close(c)",
    "local x <close> = setmetatable({}, { __close = function() while true do end end })",
    "pcall(function() local x <close> = setmetatable({}, { __close = function() while true do end "
    "end }) error 'x' end)",
    "local t = setmetatable({}, { __index = function(t, k) while true do end end }) return t.x",
    "error(setmetatable({}, { __tostring = function() while true do end end }))",
    "print(setmetatable({}, { __tostring = function() while true do end end }))",
    "table.sort({ 3, 2, 1, 5, 4 }, function() while true do end end)",
    "string.gsub('x', '.', function() while true do end end)",
    "load(function() while true do end end)",
    "require = nil while true do load('return 1')() end",
    // Calls of Lua's library that take some milliseconds each.
    "local s = string.rep('a', 200000) while true do s:gsub('a', 'b') end",
    "while true do load('return ' .. ('1+'):rep(100000) .. '1') end",
    "while true do string.format('%99d %s', 1, ('x'):rep(1e6)) end",
    "coroutine.wrap(function() local s = string.rep('a', 200000) while true do s:gsub('a', 'b') "
    "end "
    "end)()",
    "local s = string.rep('a', 200000) while true do pcall(s.gsub, s, 'a', 'b') end",
    "while true do plate { width = 1, height = 1, material = 'duran50' } end",
    "while true do pcall(plate, { width = -1 }) end",
    "p = plate { width = 1, height = 1, material = 'duran50' }\n"
    "while true do pcall(function() p.x = 1 end) pcall(function() return p.nonsense end) end",
    "while true do pcall(simulate) end",
    "while true do tostring(plate { width = 1, height = 1, material = 'duran50' }) end",
    "while true do local p = plate { width = 1, height = 1, material = 'duran50' }\n"
    "p:hole { centre = { 0.5, 0.5 }, radius = 0.1 } end",
    test::scene + "while true do s:frame { 'a.png', width = 320 } end",
    test::scene + "while true do pcall(s.frame, s, { 'a.png', width = 320 }) end",
    test::scene + "while true do s:step(1) end",
    test::scene + "while true do pcall(s.run, s, 1) end",
    test::scene + "while true do simulate(p, { spacing = 2*mm }) end",
    test::scene + "while true do pcall(simulate, p, { spacing = 2*mm }) end",
    test::scene + "while true do s:fork() end",
    test::scene + "while true do s:cracks() end",
    test::scene + "while true do s:fragments() end",
    test::scene + "while true do s:report() end",
    test::scene + "while true do s:at({ 50*mm, 20*mm }) end",
    test::scene + "while true do pcall(s.relax, s) end",
    test::scene +
        "s:on { 'every', every = 1*us, call = function() while true do end end } s:run(1)",
    test::scene +
        "s:on { 'break', call = function() pcall(function() while true do end end) end } s:run(1)",
    test::scene + "s:start(1) s:wait()",
    test::scene + "s:start(1)",
    test::scene + "show(s) while true do show(s) end",
    kept + "while true do r:frame { 'b.png', width = 320 } end",
    kept + "while true do recording 'out/a/r.h5' end",
};

TEST_F(Signals, CtrlCEndsWhateverAScriptDoes) {
  for (const std::string& script : endless_scripts) {
    const Ended ended = run(script, SIGINT);
    EXPECT_EQ(ended.code, 130) << script << "\n" << ended.err;
    fs::remove_all(folder_.path / "out");
  }
  EXPECT_GE(endless_scripts.size(), 45U);
}

// Single calls that would take minutes.
TEST_F(Signals, CtrlCEndsALongCall) {
  const std::string big = "p = plate { width = 1, height = 1, material = 'duran50' }\n";
  for (const std::string& script :
       {big + "simulate(p, { spacing = 0.15*mm })",
        big + "p:strength { modulus = 10, correlation = 1*mm } simulate(p, { spacing = 0.15*mm })",
        big + "for k = 1, 10 do p:random_cracks { count = 100000, length = { 1*mm, 2*mm }, seed = "
              "k } end\n"
              "simulate(p, { spacing = 1*mm })",
        big + "for k = 1, 200 do p:hole { centre = { 0.5, 0.5 }, radius = 0.4 - k*1e-4 } end\n"
              "simulate(p, { spacing = 0.3*mm })"}) {
    const auto begin = std::chrono::steady_clock::now();
    const Ended ended = run(script, SIGINT, 500);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(ended.code, 130) << script << "\n" << ended.err;
    EXPECT_LT(taken.count(), 30) << script;
  }
}

TEST_F(Signals, AllThatAskARunToEndLeaveWholeFiles) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const Ended ended = run(endless, number, 300);
    EXPECT_EQ(ended.code, 130) << number << ended.err;
    EXPECT_TRUE(test::is_whole_mp4(folder_.path / "out/a/a.mp4")) << number;
    EXPECT_TRUE(fs::exists(folder_.path / "out/a/a.h5")) << number;
    EXPECT_FALSE(fs::exists(folder_.path / "out/a/.a.partial.mp4")) << number;
    fs::remove_all(folder_.path / "out");
  }
}

TEST_F(Signals, AClosedTerminalMaySaySoTwice) {
  write_text(folder_.path / "a.lua", endless);
  const Ended ended = program_.run({"run", "a.lua"}, {.meanwhile = [&](pid_t process) {
                                     program_.wait_for_go();
                                     for (int k = 0; k < 5; ++k) kill(process, SIGHUP);
                                   }});
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_TRUE(test::is_whole_mp4(folder_.path / "out/a/a.mp4"));
}

TEST_F(Signals, NohupIsHeeded) {
  write_text(folder_.path / "a.lua", test::scene + "print 'go' s:run(3*ms) print 'end'");
  const Ended ended =
      program_.run({"run", "a.lua"}, {.ignored = {SIGHUP}, .meanwhile = [&](pid_t process) {
                                        program_.wait_for_go();
                                        kill(process, SIGHUP);
                                      }});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("end"));
}

TEST_F(Signals, AProgramThatIsKilledLeavesNothingThatLooksWhole) {
  EXPECT_EQ(run(endless, SIGKILL, 300).code, 128 + SIGKILL);
  EXPECT_FALSE(fs::exists(folder_.path / "out/a/a.mp4"));
  EXPECT_EQ(program_
                .run({"run", "a.lua", "-o", "again"}, {.meanwhile =
                                                           [&](pid_t process) {
                                                             program_.wait_for_go();
                                                             kill(process, SIGTERM);
                                                           }})
                .code,
            130);
}

}  // namespace
}  // namespace hackle
