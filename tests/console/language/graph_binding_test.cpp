// SPDX-License-Identifier: MIT
// What scripts are told of the graph of cracks, and the files that they save.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// A crack of 50 mm that is pulled apart until it has run some millimetres.
const std::string pulled = R"(
  local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
  p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
  p:traction { edge = "top", stress = {0, 12*MPa} }
  p:traction { edge = "bottom", stress = {0, -12*MPa} }
  p:nofail { edge = "top", depth = 3*mm }
  p:nofail { edge = "bottom", depth = 3*mm }
  s = simulate(p, { spacing = 1*mm, horizon = 3*mm })
)";

TEST(GraphBinding, ACrackOfTheSceneHasItsTip) {
  EXPECT_EQ(test::message_of(pulled + R"(
    local g = s:graph()
    assert(g.time == 0 and g.c_R == s.c_R and #g.events == 0)
    assert(#g.cracks == 1 and g.cracks[1].initial and g.cracks[1].parent == 0)
    assert(math.abs(g.cracks[1].length - 50*mm) < 1*mm)
    local tips = s:tips()
    assert(#tips == 1 and tips[1].state == "initial" and tips[1].crack == 1)
    assert(math.abs(tips[1].x - 50*mm) < 0.5*mm and math.abs(tips[1].y - 20*mm) < 0.5*mm)
    assert(tips[1].speed == 0 and tips[1].born == nil)
  )"),
            "");
}

TEST(GraphBinding, ARunningCrackHasASpeedAndAParent) {
  EXPECT_EQ(test::message_of(pulled + R"(
    s:run(16*us)
    local tips, g = s:tips(), s:graph()
    assert(#tips == 1 and tips[1].state == "running")
    assert(tips[1].speed > 300 and tips[1].speed < s.c_R)
    assert(math.abs(tips[1].share - tips[1].speed/s.c_R) < 1e-12)
    assert(math.abs(tips[1].direction) < 0.2 and tips[1].born > 4*us)
    assert(g.cracks[tips[1].crack].parent == 1 and not g.cracks[tips[1].crack].initial)
    local far = s:cracks().right
    assert(math.abs(tips[1].x - far) < 3*mm, tips[1].x/mm .. " " .. far/mm)
  )"),
            "");
}

TEST(GraphBinding, AnEventCallsAFunction) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 40*mm, height = 40*mm, material = "duran50" }
    p:crack { from = {0, 20*mm}, to = {20*mm, 20*mm} }
    p:traction { edge = "top", stress = {0, 12*MPa} }
    p:traction { edge = "bottom", stress = {0, -12*MPa} }
    p:nofail { edge = "top", depth = 3*mm }
    p:nofail { edge = "bottom", depth = 3*mm }
    local s = simulate(p, { spacing = 1*mm, horizon = 3*mm })
    local calls, seen = 0, nil
    s:on { "arrival", call = function(t) calls, seen = calls + 1, s:graph().events end }
    s:run(60*us)
    local arrived = 0
    for _, event in ipairs(s:graph().events) do
      if event.kind == "arrival" then arrived = arrived + 1 end
    end
    assert(arrived > 0 and calls > 0 and calls <= arrived, arrived .. " " .. calls)
    assert(#seen > 0 and seen[1].time < s.time)
  )"),
            "");
}

TEST(GraphBinding, IsSavedByTheEndingOfItsName) {
  EXPECT_THAT(test::message_of(pulled + "s:graph { 'graph.png' }"), HasSubstr("it ends in .json"));
}

}  // namespace
}  // namespace hackle
