// SPDX-License-Identifier: MIT
// Watching, stopping, forking and rewinding of runs.
#include "console/language/steering_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// A plate whose crack grows, solved quickly.
const std::string scenes = R"(
function plate_()
  local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
  p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
  for edge, sign in pairs { top = 1, bottom = -1 } do
    p:traction { edge = edge, stress = {0, sign*12*MPa} }
    p:nofail { edge = edge, depth = 4*mm }
  end
  return p
end
function fresh() return simulate(plate_(), { spacing = 1*mm }) end
s = fresh()
)";

std::string after_scene(const std::string& text) {
  return test::message_of(scenes + text);
}

TEST(Fork, GoesOnFromTheSameBits) {
  EXPECT_EQ(after_scene("s:run(10*us) t = s:fork()\n"
                        "assert(t.hash == s.hash and t.time == s.time)\n"
                        "s:run(10*us) t:run(10*us)\n"
                        "assert(t.hash == s.hash)"),
            "");
}

TEST(Fork, GoesItsOwnWay) {
  EXPECT_EQ(after_scene("s:run(10*us) t = s:fork()\n"
                        "t:traction { edge = 'top', stress = {0, 0} }\n"
                        "s:run(10*us) t:run(10*us)\n"
                        "whole = fresh() whole:run(20*us)\n"
                        "assert(s.hash == whole.hash and t.hash ~= whole.hash)"),
            "");
}

TEST(Rewind, GoesBackToBitsAndLoads) {
  EXPECT_EQ(after_scene("s:run(10*us) kept = s:fork() s:run(10*us) one = s.hash\n"
                        "s:traction { edge = 'top', stress = {0, 0} } s:run(10*us)\n"
                        "s:rewind(kept) assert(s.time == kept.time and s.hash == kept.hash)\n"
                        "s:run(10*us) assert(s.hash == one)\n"
                        "s:rewind(s) assert(s.hash == one)"),
            "");
}

TEST(Rewind, RefusesAnotherPlateAndFilesThatWouldGoBack) {
  EXPECT_THAT(after_scene("s:rewind(simulate(plate_(), { spacing = 2*mm }))"),
              HasSubstr("another plate or lattice"));
  EXPECT_THAT(after_scene("s:rewind(plate_())"), HasSubstr("expected a simulation, got a plate"));
  EXPECT_THAT(after_scene("s:rewind()"), HasSubstr("expected a simulation, got nothing"));
  const test::Folder folder;
  EXPECT_THAT(test::message_of(scenes + "t = s:fork() s:record { 'a.h5', every = 5*us }\n"
                                        "s:run(10*us) s:rewind(t)",
                               test::quiet(folder.path)),
              HasSubstr("rewind: its movies and records would go back in time"));
  EXPECT_EQ(test::message_of(scenes + "t = s:fork() s:record { 'a.h5', every = 5*us }\n"
                                      "s:run(10*us) s:close() s:rewind(t) assert(s.time == 0)",
                             test::quiet(folder.path)),
            "");
}

TEST(On, EveryCallsAtEvenTimesAndChangesNoBit) {
  EXPECT_EQ(
      after_scene("times = {} s:on { 'every', every = 2*us, call = function(t)\n"
                  "  assert(t == s.time) times[#times + 1] = t end }\n"
                  "s:run(7*us) s:run(3*us)\n"
                  "assert(#times == 6, #times .. ' calls')\n"
                  "for k, t in ipairs(times) do assert(math.abs(t - (k - 1)*2*us) < s.dt) end\n"
                  "whole = fresh() whole:run(10*us) assert(s.hash == whole.hash)"),
      "");
}

TEST(On, BreakCallsOnceAtTheFirstBond) {
  EXPECT_EQ(
      after_scene("count = 0 s:on { 'break', call = function(t)\n"
                  "  count, first, bonds = count + 1, t, s.damage.broken_bonds s:stop() end }\n"
                  "s:run(30*us)\n"
                  "assert(count == 1 and bonds >= 1 and s.time == first and first < 10*us)\n"
                  "s:run(10*us)\n"
                  "assert(count == 1 and math.abs(s.time - first - 10*us) <= s.dt)"),
      "");
}

TEST(On, DamageStopsACrackAtALine) {
  EXPECT_EQ(after_scene("s:on { 'damage', from = {60*mm, 10*mm}, to = {100*mm, 30*mm},\n"
                        "       call = function() s:stop() end }\n"
                        "s:run(100*us)\n"
                        "local tip = s:cracks { from = {0, 10*mm}, to = {100*mm, 30*mm} }.right\n"
                        "assert(s.time < 50*us)\n"
                        "assert(tip > 60*mm and tip < 61*mm, 'at ' .. tip/mm)"),
            "");
}

TEST(On, DamageThatIsThereAlreadyIsSeenAtOnce) {
  EXPECT_EQ(after_scene("s:on { 'damage', call = function(t) seen = t end } s:run(1*us)\n"
                        "assert(seen == 0)"),
            "");
}

// The crack extends from 0 to 50 mm; the requests are for more, or elsewhere.
TEST(On, DamageIsThatOfItsAreaAndAboveWhatIsAsked) {
  EXPECT_EQ(after_scene("s:on { 'damage', above = 0.9, call = function() more = true end }\n"
                        "s:on { 'damage', edge = 'right', depth = 40*mm,\n"
                        "       call = function() right = true end }\n"
                        "s:on { 'damage', edge = 'top', depth = 15*mm,\n"
                        "       call = function() top = true end }\n"
                        "s:on { 'damage', centre = {20*mm, 20*mm}, radius = 2*mm,\n"
                        "       call = function() here = true end }\n"
                        "s:run(1*us) assert(here and not more and not right and not top)"),
            "");
}

TEST(On, SeveralKeepTheirOwnTimes) {
  EXPECT_EQ(after_scene("one, other = 0, 0\n"
                        "s:on { 'every', every = 1*us, call = function() one = one + 1 end }\n"
                        "s:on { 'every', every = 3*us, call = function() other = other + 1 end }\n"
                        "s:run(9*us) assert(one == 10 and other == 4, one .. ' ' .. other)"),
            "");
}

// Everything a script does between two runs may also be done between two steps, with the same bits.
TEST(On, MayChangeLoads) {
  EXPECT_EQ(
      after_scene(
          "s:on { 'every', every = 10*us, call = function(t)\n"
          "  if t > 5*us and t < 15*us then\n"
          "    s:traction { edge = 'top', stress = {0, 6*MPa}, time = function(t) return 1 end }\n"
          "  end end }\n"
          "s:run(30*us)\n"
          "t = fresh() t:run(10*us)\n"
          "t:traction { edge = 'top', stress = {0, 6*MPa}, time = function(t) return 1 end }\n"
          "t:run(20*us) assert(s.hash == t.hash)"),
      "");
}

TEST(On, AnErrorStopsTheRunAndIsNamed) {
  EXPECT_EQ(
      after_scene("s:on { 'every', every = 5*us, call = function(t)\n"
                  "  if t > 7*us and not once then once = true error 'enough' end end }\n"
                  "ok, message = pcall(s.run, s, 30*us)\n"
                  "assert(not ok and tostring(message):find('on: call: the function fails at t = "
                  "1', 1, true),\n"
                  "       tostring(message))\n"
                  "assert(tostring(message):find('enough', 1, true))\n"
                  "assert(math.abs(s.time - 10*us) < s.dt)\n"
                  "s:run(5*us) assert(math.abs(s.time - 15*us) < 2*s.dt, 'what was not reached is "
                  "not owed')"),
      "");
}

TEST(On, AWatcherMayNotRunOrCloseOrFilm) {
  for (const char* call : {"s:run(1*us)", "s:step(1)", "s:close()", "s:relax {}", "s:rewind(s)",
                           "s:movie { 'a.mp4', every = 1*us }", "s:record { 'a.h5', every = 1*us }",
                           "s:on { 'break', call = function() end }"})
    EXPECT_THAT(after_scene(std::string("s:on { 'every', every = 1*us, call = function() ") + call +
                            " end } s:run(3*us)"),
                HasSubstr("the simulation is running (between two steps its loads may be changed, "
                          "or s:stop() ends the run)"))
        << call;
}

TEST(On, RefusesWhatDoesNotGoTogether) {
  EXPECT_THAT(after_scene("s:on { 'every', call = print }"), HasSubstr("on: every is missing"));
  EXPECT_THAT(after_scene("s:on { 'break', every = 1*us, call = print }"),
              HasSubstr("every does not go with break"));
  EXPECT_THAT(after_scene("s:on { 'brake', call = print }"),
              HasSubstr("expected one of every, break, damage"));
  EXPECT_THAT(after_scene("s:on { 'every', every = 1*us }"),
              HasSubstr("call is missing (a function)"));
}

TEST(Stop, OutsideOfARunDoesNothing) {
  EXPECT_EQ(after_scene("s:stop() s:run(1*us) assert(s.time > 0)"), "");
}

// Quasi-static loading calls them at the ends of its increments.
const std::string slowly_prescribed = R"(
function led(shift)
  local p = plate { width = 12*mm, height = 12*mm, material = "duran50" }
  p:crack { from = {0, 6*mm}, to = {4*mm, 6*mm} }
  p:clamp { edge = "bottom", depth = 1*mm }
  p:move { edge = "top", depth = 1*mm, displacement = {0, shift}, time = ramp(10*us) }
  for _, edge in ipairs { "top", "bottom" } do p:nofail { edge = edge, depth = 3*mm } end
  return simulate(p, { spacing = 0.5*mm })
end
)";

TEST(On, EveryIsCalledInSlowLoading) {
  EXPECT_EQ(test::message_of(
                slowly_prescribed +
                "s = led(0.1*um) times = {}\n"
                "s:on { 'every', every = 2*us, call = function(t)\n"
                "  times[#times + 1] = t assert(t == s.time) end }\n"
                "s:quasistatic { duration = 10*us, increments = 10 }\n"
                "assert(#times == 6, #times)\n"
                "for k, t in ipairs(times) do assert(math.abs(t - 2*us*(k - 1)) < 1e-12) end"),
            "");
}

TEST(On, EndsSlowLoadingAndChangesItsLoads) {
  EXPECT_EQ(test::message_of(
                slowly_prescribed +
                "s = led(0.1*um)\n"
                "s:on { 'every', every = 1*us, call = function(t)\n"
                "  if t > 2.5*us then s:stop() end end }\n"
                "q = s:quasistatic { duration = 10*us, increments = 10 }\n"
                "assert(#q.passes == 3 and math.abs(s.time - 3*us) < 1e-12)\n"
                "s = led(0) done = false\n"
                "s:on { 'every', every = 1*us, call = function(t)\n"
                "  if t > 2.5*us and not done then done = true\n"
                "    s:body_force { force = {0, 1e9} } end end }\n"
                "s:quasistatic { duration = 3*us, increments = 3 } assert(s.energy.strain == 0)\n"
                "s:quasistatic { duration = 1*us, increments = 1 } e = s.energy\n"
                "assert(e.strain > 0 and math.abs(e.external - e.strain) < 1e-3*e.strain)"),
            "");
}

TEST(On, ABreakIsHeardInSlowLoading) {
  EXPECT_EQ(test::message_of(slowly_prescribed +
                             "s = led(20*um) calls, heard = 0, false\n"
                             "s:on { 'break', call = function() calls = calls + 1\n"
                             "  assert(s.damage.broken_bonds > 0) end }\n"
                             "s:on { 'damage', call = function() heard = true end }\n"
                             "q = s:quasistatic { duration = 10*us, increments = 4 }\n"
                             "assert(q.broken > 0 and calls == 1 and heard)"),
            "");
}

}  // namespace
}  // namespace hackle
