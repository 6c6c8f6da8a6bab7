// SPDX-License-Identifier: MIT
// Compares the benchmarks of the field with the expectations in their headers. Positions agree to
// one spacing, and times to one interval of the watcher beyond the header's range.
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "scripts/watched_script.hpp"

namespace hackle {
namespace {

using test::mm, test::us;

// Returns the numbers in a text, in order.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length = 0;
    try {
      numbers.push_back(std::stod(text.substr(at), &length));
    } catch (const std::invalid_argument&) {
      length = 1;
    }
    at += length;
  }
  return numbers;
}

TEST(Benchmarks, SingleBondBreaksWhenTheClosedFormSays) {
  test::WatchedScript script("benchmarks/single_bond.lua");
  std::istringstream lines(script.printed());
  std::string time, energy;
  std::getline(lines, time);
  std::getline(lines, energy);
  const double step = script("runs[1].s.dt");
  const std::vector<double> found = numbers_in(time);
  EXPECT_NEAR(found.at(0), found.at(1), 2 * step * 1e9 + 0.01) << time;
  const double expected = std::stod(energy.substr(energy.rfind("= ") + 2));
  EXPECT_GT(expected, 0.0);
  EXPECT_NEAR(script("runs[1].s.energy.broken"), expected, 1e-5 * expected);
}

TEST(Benchmarks, PatchTestGivesTheModuliOfTheLattice) {
  for (const char* m : {"3", "4"}) {
    test::WatchedScript script("benchmarks/patch_test.lua", {{"m", m}});
    EXPECT_EQ(script("#runs"), 3);
    const std::string text = script.printed();
    const auto after = [&](const std::string& words) {
      return std::stod(text.substr(text.find(words) + words.size()));
    };
    // The strain of 1e-6 itself limits the agreement: the bond energy is not exactly quadratic.
    EXPECT_NEAR(after("per area ") / after("C11 e^2 = "), 1.0, 1e-6) << text;
    EXPECT_NEAR(after("stress ") / after("C11 e = "), 1.0, 1e-6) << text;
    EXPECT_LT(after("moved by "), 1e-12) << text;
  }
}

TEST(Benchmarks, RingPulseSpreadsAtTheSpeedOfPressureWaves) {
  test::WatchedScript script("benchmarks/ring_pulse.lua");
  const std::vector<double> found = numbers_in(script.printed());
  EXPECT_NEAR(found.at(0) / found.at(1), 1.0, 0.02) << script.printed();
  EXPECT_EQ(script("runs[1].s.damage.broken_bonds"), 0);
}

// The header says that the speed on the coarser lattice is another.
TEST(Benchmarks, ModeOneIsAcceptedButForTheCoarserLattice) {
  test::WatchedScript script("benchmarks/mode_one.lua");
  const std::string text = script.printed();
  int held = 0;
  for (std::size_t at = text.find("holds"); at != std::string::npos;
       at = text.find("holds", at + 1))
    ++held;
  EXPECT_EQ(held, 3) << text;
  EXPECT_THAT(text, testing::ContainsRegex("change of v [^\n]* 0\\.2[0-9]+ +FAILS"));
}

TEST(Benchmarks, SodaLimeLadderForksWithTheLoad) {
  test::WatchedScript script("benchmarks/soda_lime_ladder.lua");
  EXPECT_EQ(script("#runs"), 4);
  EXPECT_FALSE(script.holds("runs[1].fork"));
  EXPECT_EQ(script("runs[2].s:cracks().bands"), 2);
  EXPECT_NEAR(script("runs[2].fork_place"), 72 * mm, 1.5 * mm);
  EXPECT_EQ(script("runs[3].s:cracks { from = {0, 0}, to = {80*mm, 40*mm} }.bands"), 2);
  EXPECT_NEAR(script("runs[3].fork"), 22 * us, 0.5 * us);
  EXPECT_NEAR(script("runs[3].fork_place"), 67.5 * mm, 1 * mm / 3);
  EXPECT_GE(script("runs[4].s:cracks().bands"), 4);
  EXPECT_EQ(script.pictures(), 4U);
}

TEST(Benchmarks, BordenForksOnce) {
  test::WatchedScript script("benchmarks/borden.lua");
  EXPECT_NEAR(script("runs[1].first"), 9.4 * us, 0.5 * us);
  EXPECT_NEAR(script("runs[1].fork"), 35 * us, 0.5 * us);
  EXPECT_NEAR(script("runs[1].fork_place"), 65 * mm, 0.5 * mm);
  EXPECT_EQ(script("runs[1].s:cracks().bands"), 2);
}

// From the end of a notch at {50, 125} mm to the farthest point of the crack; the crack of the
// lower notch is its mirror image to the bit.
TEST(Benchmarks, KalthoffCracksRunOffSteeply) {
  test::WatchedScript script("benchmarks/kalthoff.lua", {}, "interval = 2*us");
  const std::string upper = "runs[1].s:cracks { from = {50*mm, 127*mm}, to = {100*mm, 199*mm} }";
  const std::string lower = "runs[1].s:cracks { from = {50*mm, 1*mm}, to = {100*mm, 73*mm} }";
  const double angle =
      std::atan2(script(upper + ".top") - 125 * mm, script(upper + ".right") - 50 * mm) * 180.0 /
      std::numbers::pi;
  EXPECT_GE(angle, 60.0);
  EXPECT_LE(angle, 70.0);
  EXPECT_EQ(script(upper + ".nodes"), script(lower + ".nodes"));
  EXPECT_EQ(script(upper + ".right"), script(lower + ".right"));
  EXPECT_NEAR(script(upper + ".top") + script(lower + ".bottom"), 200 * mm, 1e-9);
}

TEST(Benchmarks, HomaliteForksSymmetrically) {
  test::WatchedScript script("benchmarks/homalite.lua", {}, "interval = 4*us");
  EXPECT_TRUE(script.holds("runs[1].fork_place > 200*mm"));
  EXPECT_GE(script("runs[1].s:cracks().bands"), 2);
  EXPECT_TRUE(
      script.holds("runs[1].s:cracks { from = {0, 0}, to = {400*mm, 100*mm} }.nodes == "
                   "runs[1].s:cracks { from = {0, 100*mm}, to = {400*mm, 200*mm} }.nodes"));
}

// The disc of 6 mm around {60, 17} mm, minus a horizon, in which nodes have bonds to the outside:
// the largest square inside.
TEST(Benchmarks, InclusionIsNeverEntered) {
  test::WatchedScript script("benchmarks/inclusion.lua");
  const std::string in_disc =
      "runs[1].s:cracks { from = {57.2*mm, 14.2*mm}, to = {62.8*mm, 19.8*mm} }.nodes";
  EXPECT_EQ(script(in_disc), 0);
  EXPECT_LT(script("runs[1].fork_place"), 54 * mm);
  EXPECT_GT(script("runs[1].s:cracks().right"), 66 * mm);
}

// The initial cracks lie between 5 and 95 mm; once they have joined, every column of nodes meets a
// crack.
TEST(Benchmarks, RandomCracksGrowAndJoin) {
  test::WatchedScript one("benchmarks/random_cracks.lua"), again("benchmarks/random_cracks.lua");
  EXPECT_EQ(one.columns_without_crack(0.25 * mm, 99.75 * mm), 0);
  EXPECT_GT(test::WatchedScript("benchmarks/random_cracks.lua", {{"load", "0*MPa"}})
                .columns_without_crack(0.25 * mm, 99.75 * mm),
            20)
      << "they were not joined at birth";
  EXPECT_TRUE(one.holds("runs[1].s.hash == '" + again.hash() + "'"));
}

}  // namespace
}  // namespace hackle
