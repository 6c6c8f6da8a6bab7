// SPDX-License-Identifier: MIT
#include "render/diagram/scaled_axis.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

using testing::ElementsAre;

TEST(ScaledAxis, EnclosesWhatIsSeen) {
  const ScaledAxis axis({"energy", "J/m"}, {0.0, 17e3}, 5, true);
  EXPECT_EQ(axis.heading(), "energy (kJ/m)");
  EXPECT_THAT(axis.texts(), ElementsAre("0", "5", "10", "15", "20"));
  EXPECT_DOUBLE_EQ(axis.share(0.0), 0.0);
  EXPECT_DOUBLE_EQ(axis.share(10e3), 0.5);
  EXPECT_DOUBLE_EQ(axis.share(20e3), 1.0);
}

TEST(ScaledAxis, ReachesZeroWhereItIsNear) {
  EXPECT_EQ(ScaledAxis({"a", ""}, {4.0, 10.0}, 5, true).ends().min, 0.0);
  EXPECT_GT(ScaledAxis({"a", ""}, {9.0, 10.0}, 5, true).ends().min, 0.0);
  EXPECT_EQ(ScaledAxis({"a", ""}, {-10.0, -4.0}, 5, true).ends().max, 0.0);
}

TEST(ScaledAxis, KeepsARangeOfItsOwn) {
  const ScaledAxis axis({"time", "s", Ends{1e-5, 2e-5}}, {0.0, 1.0}, 5, true);
  EXPECT_EQ(axis.ends().min, 1e-5);
  EXPECT_EQ(axis.ends().max, 2e-5);
  EXPECT_EQ(axis.heading(), "time (µs)");
}

TEST(ScaledAxis, HasDecades) {
  const ScaledAxis axis({"error", "m", {}, true}, {2e-4, 0.3}, 8, true);
  EXPECT_THAT(axis.ticks(),
              ElementsAre(testing::DoubleEq(1e-4), testing::DoubleEq(1e-3), testing::DoubleEq(1e-2),
                          testing::DoubleEq(0.1), testing::DoubleEq(1.0)));
  EXPECT_NEAR(axis.share(1e-2), 0.5, 1e-12);
  EXPECT_FALSE(axis.holds(0.0));
  EXPECT_FALSE(axis.holds(-1.0));
}

// A constant, and nothing at all, still make an axis.
TEST(ScaledAxis, StandsWhateverIsSeen) {
  for (const Ends seen : {Ends{0, 0}, Ends{5, 5}, Ends{-3e-7, -3e-7}, Ends{1e12, 1e12}})
    for (const bool logarithmic : {false, true}) {
      if (logarithmic && !(seen.min > 0.0)) continue;
      const ScaledAxis axis({"a", "", {}, logarithmic}, seen, 5, true);
      EXPECT_LT(axis.ends().min, axis.ends().max) << seen.min;
      EXPECT_GE(axis.share(seen.min), 0.0);
      EXPECT_LE(axis.share(seen.max), 1.0);
      EXPECT_FALSE(axis.ticks().empty()) << seen.min;
    }
}

}  // namespace
}  // namespace hackle
