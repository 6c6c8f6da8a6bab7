// SPDX-License-Identifier: MIT
// Scripts that are stopped and go on by themselves: in the end they have said and computed the same
// as if they had never been stopped.
#include "console/replay/script_checkpoints.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Stops where `stop_at(n)` is called for the n-th time, with n from a file that is not there in the
// last life.
const std::string stopping = R"(
local calls, limit = 0, math.huge
local file = io.open "stop"
if file then limit = file:read "n" file:close() end
local function stop_here()
  calls = calls + 1
  if calls > limit then error "stopped" end
end
local function make()
  local p = plate { width = 60*mm, height = 40*mm, material = "duran50" }
  p:crack { from = {0, 20*mm}, to = {25*mm, 20*mm} }
  return p:traction { edge = "top", stress = {0, 12*MPa} }:traction { edge = "bottom", stress = {0, -12*MPa} }
end
)";

struct Story {
  const char* name;
  const char* text;
};
void PrintTo(const Story& story, std::ostream* out) {
  *out << story.name;
}

constexpr Story stories[] = {{"two_runs", R"(
      local s = simulate(make(), { spacing = 2*mm })
      local seen = {}
      s:on { "every", every = 1*us, call = function(t)
        seen[#seen + 1] = s.energy.kinetic stop_here() print(t, #seen, seen[#seen]) end }
      s:run(4.3*us) stop_here() print(s.hash, s.damage.broken_bonds)
      s:run(3.9*us) print(s.hash, s.time, s.steps, #seen))"},
                             {"loads_change", R"(
      local s = simulate(make(), { spacing = 2*mm })
      s:on { "every", every = 2*us, call = function(t)
        stop_here()
        s:traction { edge = "right", stress = {s.energy.strain * 1e5, 0} } end }
      s:on { "break", call = function(t) print("breaks", t) s:damping { rate = 1e4 } end }
      s:run(11*us) print(s.hash, s.energy.external, s.energy.damped))"},
                             {"functions", R"(
      local p = make():body_force { force = function(x, y, t) return x * t * 1e16, 0 end }
      p:move { edge = "right", depth = 2*mm, displacement = {1*um, 0}, time = function(t) return (t / (10*us))^2 end }
      local s = simulate(p, { spacing = 2*mm })
      s:on { "every", every = 3*us, call = stop_here }
      s:run(7*us) print(s.hash) s:run(6*us) print(s.hash, s.energy.external))"},
                             {"many", R"(
      local kept
      for k = 1, 3 do
        local s = simulate(make(), { spacing = 2*mm })
        s:on { "every", every = 2*us, call = stop_here }
        s:run(k*us) stop_here()
        local t = s:fork()
        t:damping { rate = k * 1e5 } t:run(3*us) s:run(3*us)
        if kept then s:rewind(t) end
        print(k, s.hash, t.hash, kept and kept.hash)
        kept = kept or t
        s, t = nil, nil collectgarbage()
      end
      kept:run(1*us) print(kept.hash))"},
                             {"slow", R"(
      local p = plate { width = 60*mm, height = 40*mm, material = "duran50" }
      p:crack { from = {0, 20*mm}, to = {25*mm, 20*mm} }
      p:clamp { edge = "bottom", depth = 4*mm }
      p:move { edge = "top", depth = 4*mm, displacement = {0, 12*um}, time = ramp(5*us) }
      local s = simulate(p, { spacing = 2*mm })
      s:on { "every", every = 1*us, call = stop_here }
      local r = s:quasistatic { duration = 5*us, increments = 7 }
      print(r.broken, r.steps, table.concat(r.passes, " "), s.hash, s.time)
      stop_here() s:relax() stop_here() s:run(2*us) print(s.hash, s.energy.released))"},
                             {"errors", R"(
      local s = simulate(make(), { spacing = 2*mm })
      s:on { "damage", from = {0, 0}, to = {60*mm, 40*mm}, above = 0.5, call = function(t) print("damaged", t) error "caught" end }
      s:on { "every", every = 2*us, call = stop_here }
      local function message(f, ...) local ok, why = pcall(f, ...) return tostring(why):match "caught" end
      for k = 1, 4 do if not message(s.run, s, 3*us) and calls > limit then stop_here() end print(k, s.time) end
      print(pcall(s.run, s, -1)) print(s.hash))"},
                             {"background", R"(
      local s = simulate(make(), { spacing = 2*mm })
      s:on { "every", every = 1*us, call = function(t) stop_here() print(t, s.energy.strain) end }
      s:start(3*us) s:wait() print(s.hash) s:start(4*us))"},
                             {"stops_itself", R"(
      local s = simulate(make(), { spacing = 2*mm })
      s:on { "every", every = 1*us, call = function(t) stop_here() if t > 3.5*us then s:stop() end end }
      s:run(9*us) print(s.time, s.hash) s:step(3) print(s.steps) s:run(2*us) print(s.time, s.hash))"},
                             {"tables", R"(
      local s = simulate(make(), { spacing = 2*mm })
      s:run(9*us)
      local cracks = s:cracks()
      print(cracks.nodes, cracks.left, cracks.right)
      print(#s:fragments(), s:at({30*mm, 20*mm}).damage, s:status().state, #s:report() > 100)
      stop_here() s:run(1*us) print(s.hash))"}};

class Lives : public testing::Test {
 protected:
  Lives() : back_(fs::current_path()) { fs::current_path(folder_.path); }
  ~Lives() override { fs::current_path(back_); }

  // Returns what the script says, and sets `failure`.
  std::string live(std::optional<int> stop, int threads, std::string& failure) {
    fs::remove("stop");
    if (stop) write_text("stop", std::to_string(*stop));
    ConsoleSettings settings = test::quiet("");
    settings.execution.threads = threads;
    settings.checkpoint_every = 1e-6;
    testing::internal::CaptureStdout();
    failure.clear();
    try {
      Console console(settings);
      console.run_file("a.lua");
    } catch (const Error& error) {
      failure = error.what();
    }
    return testing::internal::GetCapturedStdout();
  }

  test::Folder folder_;
  fs::path back_;
};

class Stopped : public Lives, public testing::WithParamInterface<Story> {};

TEST_P(Stopped, GoOnAsIfNothingHadBeen) {
  write_text("a.lua", stopping + GetParam().text);
  std::string failure;
  const std::string told = live({}, 1, failure);
  ASSERT_EQ(failure, "");
  ASSERT_THAT(told, HasSubstr("\n"));
  bool has_kept = false;  // else the script would only be run anew
  for (int first = 0; first < 6; ++first) {
    for (const int next : {first, first + 2}) {
      live(first, 1, failure);
      if (failure.empty()) continue;
      ASSERT_THAT(failure, HasSubstr("stopped")) << first;
      has_kept = has_kept || !automatic_checkpoints("out/a", "a").empty();
      live(next, 2, failure);
      EXPECT_EQ(live({}, 2, failure), told) << "stopped at " << first << " and " << next;
      EXPECT_EQ(failure, "");
    }
  }
  EXPECT_TRUE(has_kept);
  for (const auto& entry : fs::directory_iterator("out/a"))
    EXPECT_THAT(entry.path().string(), Not(HasSubstr("ckpt")));
}
INSTANTIATE_TEST_SUITE_P(OfStories, Stopped, testing::ValuesIn(stories),
                         [](const auto& info) { return std::string(info.param.name); });

constexpr const char* two_runs =
    "local s = simulate(make(), { spacing = 2*mm }) s:run(2*us) stop_here() s:run(1*us) "
    "print(s.hash)\n";

// What decides in a script must not change between its lives.
TEST_F(Lives, AScriptThatDoesSomethingElseIsToldWhere) {
  for (const auto& [text, says] : std::initializer_list<std::pair<const char*, const char*>>{
           {"s:run((file and 1 or 2)*us)", "there it had other arguments"},
           {"if file then s:run(1*us) else s:step(5) end", "at s:step: there it called s:run"},
           {"if file then s:run(1*us) end", "there it called s:run"},
           {"s:traction { edge = 'top', stress = {0, file and 1 or 2} } s:run(1*us)",
            "there it had other arguments"},
           {"s:damping { rate = 1e4 } s:run(1*us) pcall(function() return file or s:step(1) end) "
            "if not file then pcall(s.step, s, 1) end",
            "there it called s.time"}}) {
    write_text("a.lua", stopping + "local s = simulate(make(), { spacing = 2*mm })\n" + text +
                            "\nprint(s.time) stop_here() s:run(1*us)\n");
    fs::remove_all("out");
    std::string failure;
    live(0, 1, failure);
    ASSERT_THAT(failure, HasSubstr("stopped"));
    live({}, 1, failure);
    EXPECT_THAT(failure,
                AllOf(HasSubstr("does not do again"), HasSubstr(says), HasSubstr("--fresh")))
        << text;
  }
}

TEST_F(Lives, AnotherPlateIsToldEvenIfNobodyLooked) {
  write_text("a.lua", stopping +
                          "local p = make() if file then p:hole { centre = {40*mm, 10*mm}, "
                          "radius = 4*mm } end\n"
                          "local s = simulate(p, { spacing = 2*mm }) s:run(1*us) "
                          "stop_here()");
  std::string failure;
  live(0, 1, failure);
  live({}, 1, failure);
  EXPECT_THAT(failure, HasSubstr("at simulate: there it had other arguments"));
}

TEST_F(Lives, AChangedScriptIsRunAnewAndTheStateKept) {
  write_text("a.lua", stopping + two_runs);
  std::string failure;
  live(0, 1, failure);
  EXPECT_TRUE(fs::exists("out/a/a.auto.ckpt"));
  write_text("a.lua", stopping + "print 'other'\n" + two_runs);
  EXPECT_THAT(live({}, 1, failure), HasSubstr("other"));
  EXPECT_EQ(failure, "");
  EXPECT_TRUE(fs::exists("out/a/a.former.ckpt"));
  EXPECT_FALSE(fs::exists("out/a/a.auto.ckpt"));
}

TEST_F(Lives, AMistakeBehindARunIsMendedAndTheRunNotComputedAgain) {
  write_text("a.lua", stopping +
                          "local s = simulate(make(), { spacing = 2*mm }) s:run(2*us)\n"
                          "print(s.hash) print(s.energy.kinetik)\n");
  std::string failure;
  const std::string hash = live({}, 1, failure);
  EXPECT_THAT(failure, HasSubstr("kinetik"));
  write_text("a.lua", stopping +
                          "local s = simulate(make(), { spacing = 2*mm }) s:run(2*us)\n"
                          "print(s.hash) print(s.energy.kinetic > 0)\n");
  std::vector<std::string> problems;
  auto found = find_continuation("out/a", "a", problems);
  ASSERT_TRUE(found.has_value());
  ConsoleSettings settings = test::quiet("out/a");
  testing::internal::CaptureStdout();
  Console console(settings);
  console.run_on(*found);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), hash + "true\n");
  EXPECT_EQ(console.simulations().front().steps, 3);
}

TEST_F(Lives, ADamagedCheckpointGivesWayToTheOneBefore) {
  write_text("a.lua", stopping +
                          "local s = simulate(make(), { spacing = 2*mm })\n"
                          "s:on { 'every', every = 1*us, call = stop_here }\n"
                          "s:run(5*us) print(s.hash)\n");
  std::string failure;
  const std::string told = live({}, 1, failure);
  live(4, 1, failure);
  ASSERT_TRUE(fs::exists("out/a/a.auto_prev.ckpt"));
  fs::resize_file("out/a/a.auto.ckpt", fs::file_size("out/a/a.auto.ckpt") / 2);
  EXPECT_EQ(live({}, 1, failure), told);
  EXPECT_EQ(failure, "");
}

TEST_F(Lives, TwoProgramsDoNotWorkInOneFolder) {
  write_text("a.lua", stopping + two_runs);
  std::string failure;
  live(0, 1, failure);
  OutputFolder other("out/a", OutputFolder::Choice::free, {"a", {}, {}});
  other.take();
  live({}, 1, failure);
  EXPECT_THAT(failure, HasSubstr("is being written by another run"));
}

// A function fails after it has changed the plate: half of what it does would be done twice.
TEST_F(Lives, HalfAFunctionIsNotDoneTwice) {
  write_text("a.lua", stopping +
                          "local s = simulate(make(), { spacing = 2*mm })\n"
                          "s:on { 'every', every = 1*us, call = function() s:damping { rate "
                          "= 1e4 } stop_here() end }\n"
                          "s:run(5*us) print(s.hash)\n");
  std::string failure;
  const std::string told = live({}, 1, failure);
  for (int stop = 0; stop < 5; ++stop) {
    live(stop, 1, failure);
    EXPECT_EQ(live({}, 1, failure), told) << stop;
  }
}
}  // namespace
}  // namespace hackle
