// SPDX-License-Identifier: MIT
// s:fracture and s:fragments, of a simulation and of a recording.
#include "console/language/fracture_binding.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// A plate in two pieces, which fly apart and of which one is cut from an edge to its middle.
const std::string two_pieces = R"(
  p = plate { width = 60*mm, height = 40*mm, material = "duran50" }
  p:crack { from = {40*mm, 0}, to = {40*mm, 40*mm} }
  p:crack { from = {0, 20*mm}, to = {20*mm, 20*mm} }
  p:initial { velocity = {-3, 0}, from = {0, 0}, to = {40*mm, 40*mm} }
  p:initial { velocity = {2, 1}, from = {40*mm, 0}, to = {60*mm, 40*mm} }
  s = simulate(p, { spacing = 1*mm, horizon = 3*mm })
)";

TEST(FractureBinding, ListsFragmentsWithTheirMotion) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(two_pieces + R"(
    local function near(a, b) assert(math.abs(a - b) < 1e-9*math.max(1, math.abs(b)), a .. ' for ' .. b) end
    local list = s:fragments { 'frag.csv' }
    assert(#list == 2 and list[1].nodes == 1600 and list[1].number == 1)
    near(list[2].area, 800e-6) near(list[2].mass, 2235*800e-6) near(list[2].passing, 1/3)
    near(list[2].x, 50e-3) near(list[2].y, 20e-3) near(list[2].vx, 2) near(list[2].vy, 1)
    near(list[1].vx, -3) near(list[1].spin, 0)
    s:record { 'r.h5', every = 1*us } s:run(1*us) s:close()
    local r = recording 'r.h5'
    near(r:fragments()[2].vx, 2)
  )",
                             test::quiet(folder.path)),
            "");
  const std::string table = read_text(folder.path / "frag.csv");
  EXPECT_THAT(table, testing::StartsWith("number,nodes,area_m2,diameter_m,passing,"));
  EXPECT_THAT(table, HasSubstr("\n2,800,0.000"));
  EXPECT_EQ(std::ranges::count(table, '\n'), 3);
}

TEST(FractureBinding, TellsTheColumnsOfFragments) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(two_pieces + R"(
    s:log { 'a.csv', every = 1*us, 'fragments', 'fragments.largest', 'fragments.median', 'J' } s:run(1*us)
  )",
                             test::quiet(folder.path)),
            "");
  const std::string table = read_text(folder.path / "a.csv");
  EXPECT_THAT(table,
              HasSubstr("time_s,fragments,fragments_largest_m2,fragments_median_m2,J_J_per_m2"));
  EXPECT_THAT(table, HasSubstr("\n0,2,0.001"));
}

TEST(FractureBinding, MeasuresTheSameInARecording) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(R"(
    local p = plate { width = 60*mm, height = 60*mm, material = "duran50" }
    p:crack { from = {0, 30*mm}, to = {30*mm, 30*mm} }
    for edge, sign in pairs { top = 1, bottom = -1 } do p:traction { edge = edge, stress = {0, sign*MPa} } end
    local s = simulate(p, { spacing = 1*mm, horizon = 3*mm })
    s:relax()
    local f = s:fracture()
    s:record { 'f.h5', every = 1*us } s:run(1*us) s:close()
    local g = recording 'f.h5':fracture()
    assert(math.abs(f.x - 30e-3) < 0.3e-3 and math.abs(f.y - 30e-3) < 1e-9 and f.dx == 1 and f.dy == 0)
    assert(#f.rings == 4 and f.rings[1].radius < f.rings[4].radius)
    assert(math.abs(g.J/f.J - 1) < 1e-5, g.J/f.J)
    assert(math.abs(f.J_over_G0*f.G0/f.J - 1) < 1e-12)
    local huge = s:fracture { direction = {1e300, 0} }  -- no length but a direction
    assert(huge.J == s:fracture { direction = {1, 0} }.J and huge.dx == 1)
    local one = s:fracture { {30*mm, 30*mm}, radii = {8*mm} }
    assert(#one.rings == 1 and math.abs(one.J/f.J - 1) < 0.02)
  )",
                             test::quiet(folder.path)),
            "");
}

TEST(FractureBinding, RefusesBadInput) {
  const auto told = [](const std::string& call) {
    return test::message_of(two_pieces + "s:" + call);
  };
  EXPECT_THAT(told("fracture { direction = {0, 0} }"), HasSubstr("which is no direction"));
  EXPECT_THAT(told("fracture { along = {0, 0} }"), HasSubstr("which is no direction"));
  EXPECT_THAT(told("fracture { radii = {} }"), HasSubstr("radii"));
  EXPECT_THAT(told("fracture { {20*mm, 20*mm}, radii = {1*mm} }"), HasSubstr("too small"));
  EXPECT_THAT(told("fracture { tipp = {0, 0} }"), HasSubstr("did you mean 'tip'?"));
  EXPECT_THAT(told("fragments { 'a.png' }"), HasSubstr(".csv"));
  EXPECT_THAT(test::message_of(two_pieces + "print(s:fragments()[1].aera)"),
              HasSubstr("did you mean 'area'?"));
}

}  // namespace
}  // namespace hackle
