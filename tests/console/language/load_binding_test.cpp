// SPDX-License-Identifier: MIT
#include "console/language/load_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string plate_and_sim =
    "p = plate { width = 20*mm, height = 10*mm, material = 'duran50' }\n"
    "local function sim(q) return simulate(q or p, { spacing = 0.5*mm }) end\n";

TEST(LoadBinding, LoadsOfAPlateAddUpAndCallsChain) {
  EXPECT_EQ(
      test::message_of(
          plate_and_sim +
          "p:traction { edge = 'top', stress = {0, 1*MPa} }\n"
          " :traction { edge = 'top', stress = {0, 1*MPa}, time = ramp(1*us), depth = 1*mm }\n"
          " :clamp { edge = 'bottom', depth = 1*mm }:damping { rate = 1e4 }\n"
          "assert(tostring(p):find('2 tractions, 1 support, damping', 1, true), tostring(p))"),
      "");
}

TEST(LoadBinding, AChangeInARunReplacesTheLikeLoadAtThePlace) {
  EXPECT_EQ(
      test::message_of(plate_and_sim +
                       "p:traction { edge = 'top', stress = {0, 1*MPa} }\n"
                       "local s = sim() s:run(1*us)\n"
                       "assert(s.energy.external > 0)\n"
                       "s:traction { edge = 'top', stress = {0, 0} }:damping { rate = 0 }\n"
                       "local e = s.energy.external s:run(1*us) assert(s.energy.external == e)\n"
                       "s:move { edge = 'left', depth = 1*mm, velocity = {-1, 0}, axis = 'x' }\n"
                       "s:run(1*us) assert(s.energy.external > e)\n"
                       "s:release { edge = 'left', depth = 1*mm } e = s.energy.external\n"
                       "s:run(1*us) assert(s.energy.external == e)\n"
                       "assert(not tostring(p):find('support'))"),
      "");
}

TEST(LoadBinding, FunctionsOfPlaceAndTimeAreCalledWithMetresAndSeconds) {
  EXPECT_EQ(
      test::message_of(
          plate_and_sim +
          "local least, most, last = 1, 0, -1\n"
          "p:traction { edge = 'top', stress = function(x, y)\n"
          "  assert(y > 9*mm and y < 10*mm) least = math.min(least, x) most = math.max(most, x)\n"
          "  return 0, 1*MPa end,\n"
          "  time = function(t) assert(t > last) last = t return 1 end }\n"
          "local s = sim()\n"
          "assert(math.abs(least - 0.25*mm) < 1e-12 and math.abs(most - 19.75*mm) < 1e-12)\n"
          "last = -1 s:run(1*us) assert(math.abs(last - s.time) < 2*s.dt)"),
      "");
}

TEST(LoadBinding, AFunctionOutlivesTheScriptsHoldOnIt) {
  EXPECT_EQ(test::message_of(plate_and_sim +
                             "do local f = function(t) return 1 end\n"
                             "p:traction { edge = 'top', stress = {0, 1*MPa}, time = f } end\n"
                             "local s = sim() p = nil collectgarbage() collectgarbage()\n"
                             "for k = 1, 3 do s:run(1*us) collectgarbage() end"),
            "");
}

TEST(LoadBinding, AFunctionMayNotRunOrChangeTheSimulation) {
  EXPECT_THAT(test::message_of(plate_and_sim +
                               "local s = sim()\n"
                               "s:traction { edge = 'top', stress = {0, 1}, time = function(t)\n"
                               "  if t > 1*us then s:run(1*us) end return 1 end }\n"
                               "s:run(5*us)"),
              HasSubstr("the simulation is running"));
}

TEST(LoadBinding, AmplitudesAreListsOfPairs) {
  EXPECT_EQ(test::message_of("local r = ramp(2*us) assert(#r == 2 and r[2][1] == 2*us)\n"
                             "local q = pulse(1*us, 3*us)\n"
                             "assert(q[1][2] == 0 and q[2][2] == 1 and q[4][1] == 4*us)\n"
                             "assert(step_at(1*us)[1][1] == 1*us)"),
            "");
}

struct Bad {
  const char* call;
  const char* part;  // of the message
};

class BadLoads : public testing::TestWithParam<Bad> {};

TEST_P(BadLoads, AreRefusedAndSayWhy) {
  EXPECT_THAT(test::message_of(plate_and_sim + GetParam().call), HasSubstr(GetParam().part));
}

INSTANTIATE_TEST_SUITE_P(
    Calls, BadLoads,
    testing::Values(
        Bad{"p:traction { edge = 'top' }", "stress is missing"},
        Bad{"p:traction { edge = 'topp', stress = {0, 1} }", "did you mean 'top'?"},
        Bad{"p:traction { edge = 'top', stress = 5 }", "or a function of x and y"},
        Bad{"p:traction { edge = 'top', stress = {0, 0/0} }", "expected finite numbers"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, depth = 0 }", "must be above 0 m"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = 3 }", "{{t, factor}, ...}"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = {} }", "is not a list of pairs"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = {{0, 1, 2}} }", "list of pairs"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = {{1, 1}, {0, 1}} }", "goes back"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = {{0, 1/0}} }", "not finite"},
        Bad{"p:traction { edge = 'top', stress = function() end } sim()",
            "the function returns nothing at x = 0.25 mm, y = 9.75 mm"},
        Bad{"p:traction { edge = 'top', stress = function(x) if x > 10*mm then error('no') end\n"
            "return 0, 1 end } sim()",
            "the function fails at x = 10.25 mm"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = function(t) while t >= 0 do end "
            "end }\n"
            "sim():step(1)",
            "it does not return"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, time = function(t)\n"
            "if t < 1*us then return 1 end end } sim():run(2*us)",
            "the function returns nothing at t = 1 us"},
        Bad{"p:traction { edge = 'top', stress = function(x, y) return f(x, y) end }\n"
            "function f(x, y) return f(x, y) + 1 end sim()",
            "overflow"},
        Bad{"p:pressure { rim = 'bore', pressure = 1 } sim()",
            "no hole, notch, outline or crack named 'bore'"},
        Bad{"p:traction { stress = {0, 1} }", "it is not clear where it acts"},
        Bad{"p:traction { edge = 'top', rim = 'a', stress = {0, 1} }", "not clear where it acts"},
        Bad{"p:traction { edge = 'top', stress = {0, 1}, angles = {0, 1} }", "angles are of a rim"},
        Bad{"p:traction { rim = 'a', stress = {0, 1}, depth = 1*mm }", "depth is of an edge"},
        Bad{"p:traction { rim = 'a', stress = {0, 1}, angles = {1, 1} }", "goes 0 degrees"},
        Bad{"p:pressure { rim = 'a', pressure = 1, angles = {0, 361*deg} }", "goes 361 degrees"},
        Bad{"p:pressure { rim = 'a', pressure = 1, angles = {0, 1000} }", "between -100 and 100"},
        Bad{"p:hole { centre = {5*mm, 5*mm}, radius = 2*mm, name = 'bore' }\n"
            "p:traction { rim = 'boer', stress = {0, 1} } sim()",
            "did you mean 'bore'?"},
        Bad{"p:crack { from = {5*mm, 5*mm}, to = {9*mm, 5*mm}, name = 'slit' }\n"
            "p:traction { rim = 'slit', stress = {0, 1} } sim()",
            "p:pressure pushes them apart"},
        Bad{"p:traction { edge = 'top', stress = function(x, y, t)\n"
            "if t < 1*us then return 0, 1 end end } sim():run(2*us)",
            "y = 9.75 mm, t = "},
        Bad{"p:body_force { force = function(x, y, t) return 'hot', 1 end } sim()",
            "returns the text 'hot' at x = 0.25 mm, y = 0.25 mm, t = 0 s"},
        Bad{"p:pressure { rim = '', pressure = 1 }", "empty text"},
        Bad{"p:body_force { force = {0, 1}, edge = 'top' }", "the area is not clear"},
        Bad{"p:body_force { force = {0, 1}, from = {0, 0}, to = {0, 0} }", "no area"},
        Bad{"p:clamp { }", "no area is given"},
        Bad{"p:clamp { edge = 'top', depth = 1*mm, axis = 'z' }", "one of both, x, y"},
        Bad{"p:clamp { centre = {1, 1}, radius = -1 }", "must be above 0 m"},
        Bad{"p:clamp { centre = {1, 1}, radius = 1*mm } sim()", "there is no node in its area"},
        Bad{"p:move { edge = 'top', depth = 1*mm }", "give velocity or displacement"},
        Bad{"p:move { edge = 'top', depth = 1*mm, velocity = {0, 1}, displacement = {0, 1} }",
            "give velocity or displacement"},
        Bad{"p:temperature { change = {1, 2} }", "or a function of x and y"},
        Bad{"p:damping { rate = -1 }", "at least 0 1/s"},
        Bad{"p:damping { rate = 1/0 }", "expected a finite number"},
        Bad{"p:initial { }", "no motion is given"},
        Bad{"sim():release { }", "nothing is clamped or moved there"},
        Bad{"sim():clamp { edge = 'top' }", "the area is not clear"}, Bad{"ramp(0)", "above 0 s"},
        Bad{"pulse()", "duration is missing"}, Bad{"step_at(-1)", "at least 0 s"}));

}  // namespace
}  // namespace hackle
