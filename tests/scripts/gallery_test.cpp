// SPDX-License-Identifier: MIT
// What the pictures of the gallery must show.
#include <regex>

#include <fmt/format.h>

#include "scripts/watched_script.hpp"

namespace hackle {
namespace {

using test::mm;

// Damage beyond the cold skin of 1 mm counts as a crack.
TEST(Gallery, QuenchMakesAnArrayOfCracks) {
  test::WatchedScript script("gallery/quench.lua", {{"spacing", "0.2*mm"}});
  EXPECT_TRUE(script.holds(R"((function()
    local c = runs[1].s:cracks()
    local count, inside = 0, false
    for x = 0.1*mm, 50*mm, 0.2*mm do
      local on = runs[1].s:cracks { from = {x - 0.05*mm, 1*mm}, to = {x + 0.05*mm, 2*mm} }.nodes > 0
      if on and not inside then count = count + 1 end
      inside = on
    end
    return count >= 10 and c.top < 9*mm
  end)())"));
}

// A scene without scatter is symmetric to the bit: as many bonds would break above as below.
TEST(Gallery, HeterogeneousGlassBranchesWithoutSymmetry) {
  test::WatchedScript script("gallery/heterogeneous.lua");
  EXPECT_GE(script("runs[1].s:cracks().bands"), 4);
  EXPECT_TRUE(
      script.holds("runs[1].s:cracks { from = {0, 0}, to = {100*mm, 20*mm} }.nodes ~= "
                   "runs[1].s:cracks { from = {0, 20*mm}, to = {100*mm, 40*mm} }.nodes"));
}

// The scene is the paper's first plate with another field.
TEST(Gallery, ThePhotoelasticPlateForksAsTheFirstDoes) {
  test::WatchedScript script("gallery/photoelastic.lua",
                             {{"spacing", "0.5*mm"}, {"horizon", "2*mm"}}, "interval = 1*us");
  EXPECT_EQ(script("runs[1].s:cracks().bands"), 2);
  EXPECT_NEAR(script("runs[1].s:cracks().fork"), 67 * mm, 3 * mm);
}

TEST(Gallery, TheRingFliesApart) {
  test::WatchedScript script("gallery/ring.lua", {}, "interval = 2*us");
  EXPECT_TRUE(script.holds(R"((function()
    local large = 0
    for _, one in ipairs(runs[1].s:fragments()) do if one.nodes > 50 then large = large + 1 end end
    return large >= 10
  end)())"));
  EXPECT_EQ(script.pictures(), 1U);
}

// The holes extend from 13 to 23 and from 37 to 47 mm; the cracks reach both and join.
TEST(Gallery, TwoHolesDrawCracks) {
  test::WatchedScript script("gallery/two_holes.lua", {}, "interval = 5*us");
  EXPECT_GT(script("runs[1].s:cracks { from = {24*mm, 50*mm}, to = {36*mm, 70*mm} }.nodes"), 24);
  EXPECT_LT(script("runs[1].s:cracks { from = {24*mm, 0}, to = {36*mm, 120*mm} }.top"), 65 * mm);
  EXPECT_GT(script("runs[1].s:cracks { from = {24*mm, 0}, to = {36*mm, 120*mm} }.bottom"), 55 * mm);
}

// The cusp lies at 50.5 mm; the branches leave the glass at about {18.5, 12.5} and {46, 13.5} mm.
TEST(Gallery, OwnPictureBreaksFromItsCusp) {
  test::WatchedScript script(
      "gallery/own_picture.lua", {},
      "interval = 1*us function log(s) if not start then local c = s:cracks() "
      "if c.nodes > 0 then start = c.bottom end end end");
  EXPECT_GT(script("start"), 40 * mm);
  EXPECT_LT(script("runs[1].s:cracks { from = {15*mm, 10*mm}, to = {25*mm, 40*mm} }.bottom"),
            14 * mm);
  EXPECT_GT(script("runs[1].s:cracks { from = {35*mm, 12*mm}, to = {50*mm, 40*mm} }.right"),
            42 * mm);
}

// The bar holds until the crack starts; then nothing bears the grip.
TEST(Gallery, TheBarBearsALoadUntilItsCrackStarts) {
  test::WatchedScript script("gallery/load_displacement.lua");
  EXPECT_EQ(script("#runs"), 2);
  for (const char* run : {"runs[1]", "runs[2]"}) {
    EXPECT_GT(script(fmt::format("{}.s.damage.broken_bonds", run)), 200) << run;
    EXPECT_GT(script(fmt::format("{}.s:reaction('grip').uy", run)), 0.3 * mm) << run;
  }
}

// On lattices this coarse the soft rim counts for up to 15 %; see specimens_test.cpp.
TEST(Gallery, TheSpecimensComeNearTheHandbook) {
  test::WatchedScript script("gallery/specimens.lua");
  EXPECT_EQ(script("#runs"), 8);
  EXPECT_EQ(script.pictures(), 9U);
  const std::string lines = script.printed();
  const std::regex percentage("\\(([+-][0-9.]+) %\\)");
  int seen = 0;
  for (std::sregex_iterator match(lines.begin(), lines.end(), percentage), none; match != none;
       ++match, ++seen)
    EXPECT_NEAR(std::stod((*match)[1]), 7.0, 8.5) << lines;
  EXPECT_EQ(seen, 8);
}

// The nodes within 3 mm of the impact are dust or nearly so.
TEST(Gallery, ADiscShattersAPlate) {
  test::WatchedScript script("gallery/shatter.lua", {}, "interval = 2*us");
  EXPECT_EQ(script("runs[1].s:cracks { from = {0, 29*mm}, to = {3*mm, 31*mm} }.nodes"), 12 * 8);
  for (const char* far : {"right", "top"})
    EXPECT_GT(script(std::string("runs[1].s:cracks().") + far), 59 * mm) << far;
  EXPECT_GT(script("#runs[1].s:fragments()"), 5);
  EXPECT_GT(script("runs[1].s.energy.broken"), 100);
}

}  // namespace
}  // namespace hackle
