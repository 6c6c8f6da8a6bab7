// SPDX-License-Identifier: MIT
#include "console/language/relax_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

TEST(RelaxBinding, ReturnsWhatItTook) {
  EXPECT_EQ(test::message_of(test::scene + R"(
    local r = s:relax()
    assert(r.steps > 0 and r.residual <= 1e-8 and r.most > 0 and r.beyond >= 0)
    assert(s.energy.kinetic == 0 and s.energy.strain > 0)
    assert(s:relax { tolerance = 1e-6 }.steps == 0)
  )"),
            "");
}

TEST(RelaxBinding, QuasistaticLoadingReturnsItsPasses) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 10*mm, height = 10*mm, material = "duran50" }
    local s = simulate(p, { spacing = 1*mm })
    local r = s:quasistatic { duration = 4*us, increments = 2 }
    assert(#r.passes == 2 and r.passes[1] == 1 and r.broken == 0 and r.bears)
    assert(s.time > 0)
  )"),
            "");
}

TEST(RelaxBinding, TellsWhatPlatensBearAtRest) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 10*mm, height = 10*mm, material = "duran50" }
    p:platen { from = {0, 0}, to = {10*mm, -3*mm} }
    p:platen { from = {0, 10*mm}, to = {10*mm, 13*mm}, force = {0, -1e5} }
    local s = simulate(p, { spacing = 1*mm })
    s:relax()
    local below, above = s.reactions[1], s.reactions[2]
    assert(#s.reactions == 2 and above.body == "platen" and above.number == 2)
    assert(math.abs(above.fy - 1e5) < 1 and math.abs(below.fy + 1e5) < 1 and above.fx == 0)
    assert(below.x == 5*mm and above.y < 11.5*mm)
    assert(not pcall(function() return above.force end))
  )"),
            "");
}

TEST(RelaxBinding, RefusesWhatMakesNoSense) {
  EXPECT_THAT(test::message_of(test::scene + "s:relax { tolerance = 2 }"), HasSubstr("tolerance"));
  EXPECT_THAT(test::message_of(test::scene + "s:relax { tolerence = 1e-3 }"),
              HasSubstr("did you mean 'tolerance'"));
  EXPECT_THAT(test::message_of(test::scene + "s:quasistatic {}"), HasSubstr("duration"));
}

}  // namespace
}  // namespace hackle
