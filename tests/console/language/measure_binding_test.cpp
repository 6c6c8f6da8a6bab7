// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Nodes at 1, 3, ... mm; the cut at mid-height lies between those at 19 and 21 mm. Within a horizon
// of its end at 50 mm, nodes have lost fewer bonds.
TEST(MeasureBinding, FindsCracksInAnArea) {
  EXPECT_EQ(test::message_of(test::scene + R"(
    local c = s:cracks()
    assert(c.nodes > 40 and c.nodes <= 50 and c.bands == 1 and c.fork == nil)
    assert(math.abs(c.left - 1*mm) < 1e-9 and c.right > 41.5*mm and c.right < 49.5*mm)
    assert(math.abs(c.bottom - 19*mm) < 1e-9 and math.abs(c.top - 21*mm) < 1e-9)
    local half = s:cracks { from = {0, 20*mm}, to = {20*mm, 40*mm} }
    assert(half.nodes == 10 and math.abs(half.bottom - 21*mm) < 1e-9)
    local none = s:cracks { from = {60*mm, 0}, to = {100*mm, 40*mm} }
    assert(none.nodes == 0 and none.bands == 0 and none.left == nil)
  )"),
            "");
}

TEST(MeasureBinding, CracksSideBySideAreNoFork) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 100*mm, height = 80*mm, material = "duran50" }
    p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
    p:crack { from = {20*mm, 60*mm}, to = {50*mm, 60*mm} }
    local c = simulate(p, { spacing = 2*mm }):cracks()
    assert(c.bands == 2 and c.fork == nil)
  )"),
            "");
}

TEST(MeasureBinding, CountsFragmentsTheLargestFirst) {
  EXPECT_EQ(test::message_of(test::scene + R"(
    assert(#s:fragments() == 1 and s:fragments()[1].nodes == 1000)
    p:crack { from = {20*mm, 0}, to = {20*mm, 40*mm} }
    local list = simulate(p, { spacing = 2*mm }):fragments()
    assert(#list == 3 and list[1].nodes == 800 and list[2].nodes == 100 and list[3].nodes == 100)
  )"),
            "");
}

// Under a uniform strain a bond along x is stretched by it, inside the plate all stresses follow
// from the moduli of the lattice, and the energy density is half their product.
TEST(MeasureBinding, TellsWhatTheBondsOfANodeSay) {
  EXPECT_EQ(test::message_of(R"(
    local warm = material { like = "duran50", alphaT = 4e-6 }
    local p = plate { width = 40*mm, height = 40*mm, material = warm }
    p:initial { velocity = {3, -2} }
    p:temperature { change = 50 }
    local s = simulate(p, { spacing = 1*mm })
    local inside = s:at({20*mm, 20*mm})
    assert(math.abs(inside.vx - 3) < 1e-12 and math.abs(inside.vy + 2) < 1e-12)
    assert(math.abs(inside.temperature - 50) < 1e-9)
    local cold = plate { width = 40*mm, height = 40*mm, material = "duran50" }
    cold:initial { displacement = function(x, y) return 1e-6*x, 0 end }
    s = simulate(cold, { spacing = 1*mm })
    inside = s:at({20*mm, 20*mm})
    local E, nu = s.E, s.nu
    local C11 = E / (1 - nu^2)
    assert(math.abs(inside.stress_xx / (C11 * 1e-6) - 1) < 1e-5)
    assert(math.abs(inside.stress_yy / (nu * C11 * 1e-6) - 1) < 1e-5)
    assert(math.abs(inside.stress_xy) < 1e-5 * inside.stress_xx)
    assert(math.abs(inside.energy / (0.5 * inside.stress_xx * 1e-6) - 1) < 1e-5)
    assert(math.abs(inside.stretch / (1e-6 / s.s0) - 1) < 1e-5)
  )"),
            "");
}

TEST(MeasureBinding, AMemberThatIsMissingIsAnErrorWithTheNearest) {
  const auto told = [](const char* expression) {
    return test::message_of(test::scene + fmt::format("local x = {}", expression));
  };
  EXPECT_THAT(told("s.energy.kinetc"),
              HasSubstr("s.energy has no 'kinetc' (did you mean 'kinetic'?)"));
  EXPECT_THAT(told("s.damage.broken"), HasSubstr("s.damage has no 'broken'"));
  EXPECT_THAT(told("s:cracks().tip"), HasSubstr("it has nodes, bands, fork, left"));
  EXPECT_THAT(told("s:at({0, 0}).u"), HasSubstr("s:at() has no 'u'"));
  EXPECT_THAT(told("s:at({0, 0})[1]"), HasSubstr("s:at() has no '1'"));
  EXPECT_THAT(told("s:status().tme"), HasSubstr("(did you mean 'time'?)"));
  EXPECT_THAT(told("s:relax().step"), HasSubstr("(did you mean 'steps'?)"));
  EXPECT_EQ(told("s:cracks().fork"), "");
}

// What the report prints of lattice and model can be computed with.
TEST(MeasureBinding, TheModelIsKnownToTheScript) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 20*mm, height = 20*mm, material = "duran50" }
    local s = simulate(p, { spacing = 0.5*mm, horizon = 1.5*mm })
    assert(s.spacing == 0.5*mm and s.horizon == 1.5*mm and s.m == 3)
    assert(math.abs(s.E / p.material.E - 1) < 1e-9 and math.abs(s.nu - 1/3) < 0.02)
    assert(math.abs(s.G0 / p.material.G0 - 1) < 1e-9)
    assert(math.abs(s.c_L / math.sqrt(s.E / (p.material.rho * (1 - s.nu^2))) - 1) < 1e-12)
    assert(math.abs(s.c_S / math.sqrt(s.E / (2 * p.material.rho * (1 + s.nu))) - 1) < 1e-12)
    assert(s.c_R > 0.9 * s.c_S and s.c_R < s.c_S and s.s0 > 0)
    assert(p.material.name == "Duran 50 glass")
  )"),
            "");
}

TEST(MeasureBinding, TellsWhatANodeDoes) {
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 20*mm, height = 10*mm, material = "duran50" }
    p:initial { displacement = function(x, y) return 1e-3*x, -1e-3*y end }
    local s = simulate(p, { spacing = 1*mm })
    local corner, middle = s:at({0, 0}), s:at({20*mm, 10*mm})
    assert(math.abs(corner.x - 0.5*mm) < 1e-12 and math.abs(corner.ux - 0.5e-6) < 1e-15)
    assert(math.abs(middle.y - 9.5*mm) < 1e-12 and math.abs(middle.uy + 9.5e-6) < 1e-15)
    assert(corner.damage == 0)
  )"),
            "");
}

TEST(MeasureBinding, RefusesBadInput) {
  struct Bad {
    const char* call;
    const char* message;
  };
  for (const Bad& bad : {
           Bad{"cracks { from = {0, 0} }", "given together"},
           {"cracks { from = {1, 0}, to = {0, 1} }", "the area is empty"},
           {"cracks { form = {0, 0} }", "did you mean 'from'?"},
           {"cracks(3)", "expected options in braces"},
           {"fragments(2)", "expected options in braces"},
           {"at()", "place is missing"},
           {"at({1, 0})", "beyond the plate along x"},
           {"at({0, -1*mm})", "beyond the plate along y"},
           {"at({0, 0/0})", "finite"},
       })
    EXPECT_THAT(test::message_of(test::scene + "s:" + bad.call), HasSubstr(bad.message))
        << bad.call;
}

}  // namespace
}  // namespace hackle
