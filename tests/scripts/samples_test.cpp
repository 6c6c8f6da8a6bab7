// SPDX-License-Identifier: MIT
// The paper's plates as their scripts solve them. Checks of scenario/paper_plates_test.cpp on the
// edge crack are not repeated. Positions agree to one spacing, and times to one interval of the
// watcher beyond the header's range.
#include "scripts/watched_script.hpp"

namespace hackle {
namespace {

using test::mm, test::us;
constexpr double interval = 0.5 * us;

// The header: 6 us, 67 mm, 25 us.
TEST(Samples, EdgeCrackForksWhereItsHeaderSays) {
  test::WatchedScript script("samples/edge_crack.lua");
  EXPECT_NEAR(script("runs[1].first"), 6 * us, 0.5 * us + interval);
  EXPECT_NEAR(script("runs[1].fork"), 25 * us, 0.5 * us + interval);
  EXPECT_NEAR(script("runs[1].fork_place"), 67 * mm, 0.5 * mm + 0.5 * mm);
  EXPECT_EQ(script("runs[1].s:cracks().bands"), 2);
  EXPECT_EQ(script.pictures(), 1U);
}

// The header: 4 us, a fork at 58 mm, seen two horizons later, and four branches from 76 mm on.
TEST(Samples, EdgeCrack24MPaBranchesAgain) {
  test::WatchedScript script("samples/edge_crack_24mpa.lua");
  EXPECT_NEAR(script("runs[1].first"), 4 * us, 0.5 * us + interval);
  EXPECT_NEAR(script("runs[1].fork"), 11 * us, 0.5 * us + interval);
  EXPECT_NEAR(script("runs[1].fork_place"), 58.7 * mm, 1 * mm);
  EXPECT_EQ(script("runs[1].s:cracks { from = {61*mm, 0}, to = {74*mm, 40*mm} }.bands"), 2);
  EXPECT_EQ(script("runs[1].s:cracks { from = {76*mm, 0}, to = {82*mm, 40*mm} }.bands"), 4);
}

// Straight: within two spacings of mid-height between 10 and 90 mm; rough near the edges.
TEST(Samples, CentreCrackRunsStraightToBothEdges) {
  test::WatchedScript script("samples/centre_crack.lua", {},
                             "function log(s) local c = s:cracks() "
                             "if not through and c.nodes > 0 and c.left < 1*mm and c.right > 99*mm "
                             "then through = s.time end end");
  const std::string inside = "runs[1].s:cracks { from = {10*mm, 0}, to = {90*mm, 40*mm} }";
  EXPECT_NEAR(script("runs[1].first"), 5.25 * us, 0.5 * us + interval);
  EXPECT_LE(script(inside + ".top"), 21 * mm);
  EXPECT_GE(script(inside + ".bottom"), 19 * mm);
  EXPECT_NEAR(script("through"), 25 * us, 2.5 * us);
  EXPECT_GE(script("#runs[1].s:fragments()"), 2);
}

TEST(Samples, CentreCrackStaysAtRestUnderTheLoadThatThePaperPrints) {
  test::WatchedScript script("samples/centre_crack.lua", {{"load", "1.45*MPa"}});
  EXPECT_EQ(script("runs[1].s.damage.broken_bonds"), 0);
}

// Cracks from both sides of the hole (10 to 30 mm), straight, through by 40 us; none before 15 us.
TEST(Samples, HoleCracksAtItsSides) {
  test::WatchedScript script(
      "samples/hole.lua", {},
      "function log(s) local c = s:cracks() if not through and c.nodes > 0 and c.left < 1*mm and "
      "c.right > 39*mm then through = s.time end end");
  EXPECT_NEAR(script("runs[1].first"), 20 * us, 2 * us);
  EXPECT_LE(script("through"), 40 * us + interval);
  for (const std::string side :
       {"{0, 0}, to = {10*mm, 100*mm}", "{30*mm, 0}, to = {40*mm, 100*mm}"}) {
    const std::string part = "runs[1].s:cracks { from = " + side + " }";
    EXPECT_GT(script(part + ".nodes"), 20) << side;
    EXPECT_LE(script(part + ".top"), 52 * mm) << side;
    EXPECT_GE(script(part + ".bottom"), 48 * mm) << side;
    EXPECT_EQ(script(part + ".bands"), 1) << side;
  }
}

// The edge crack ends at 20 mm; the hole extends from 50 to 70 mm.
TEST(Samples, HoleAndCrackJoin) {
  test::WatchedScript script("samples/hole_and_crack.lua", {}, R"(
    interval = 2*us
    local function near(s, x) return s:cracks { from = {x - 1.5*mm, 140*mm}, to = {x + 1.5*mm, 160*mm} }.nodes > 0 end
    function log(s)
      if s.time <= 34*us + s.dt then started = near(s, 23*mm) and near(s, 48.5*mm) and near(s, 71.5*mm) end
      if not joined and near(s, 23*mm) and near(s, 30*mm) and near(s, 35*mm) and near(s, 40*mm)
         and near(s, 45*mm) then joined = s.time end
    end)");
  EXPECT_TRUE(script.holds("started"));
  EXPECT_LE(script("joined"), 42 * us + 2 * us);
  EXPECT_EQ(script.columns_without_crack(0.25 * mm, 49.25 * mm), 0) << "left of the hole";
  EXPECT_EQ(script.columns_without_crack(70.75 * mm, 99.75 * mm), 0) << "right of it";
  EXPECT_LE(script("runs[1].s:cracks().top"), 156 * mm) << "no fork";
  EXPECT_GE(script("runs[1].s:cracks().bottom"), 144 * mm);
}

}  // namespace
}  // namespace hackle
