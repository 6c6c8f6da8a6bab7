// SPDX-License-Identifier: MIT
#include "solver/rank_cost.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr Network fast{"fast", 1e-6, 10e9, 2e-6}, free_of_charge{"free", 0.0, 1e300, 0.0};
constexpr SharedPlate plate{.columns = 1e4, .rows = 1e4, .node_seconds = 1e-8};

TEST(RankCost, OfOneRankIsThatOfItsNodes) {
  const StepCost cost = cost_of_step(plate, 1, fast);
  EXPECT_DOUBLE_EQ(cost.total(), 1e8 * 1e-8);
  EXPECT_DOUBLE_EQ(strong_efficiency(plate, 1, fast), 1.0);
}

TEST(RankCost, WithoutANetworkOnlyTheRowsComputedTwiceAreLost) {
  // 2500 rows and 3 * 4/2 more.
  EXPECT_NEAR(strong_efficiency(plate, 4, free_of_charge), 2500.0 / 2506.0, 1e-12);
}

TEST(RankCost, MessagesAreHiddenBehindInnerRowsUntilThereAreNone) {
  // 640 kB take 64 us; an inner row takes 100 us.
  EXPECT_DOUBLE_EQ(halo_bytes(plate), 2 * 4 * 1e4 * 8);
  EXPECT_DOUBLE_EQ(cost_of_step(plate, 100, fast).halo, 1e-6);
  EXPECT_NEAR(cost_of_step(plate, 1000, fast).halo, 64e-6 + 2e-6, 1e-9);
}

TEST(RankCost, CollectiveCallsGrowWithTheLogarithmOfTheRanks) {
  EXPECT_DOUBLE_EQ(cost_of_step(plate, 16, fast).agreement, 5 * 2e-6 * 4);
  EXPECT_DOUBLE_EQ(cost_of_step(plate, 256, fast).agreement, 5 * 2e-6 * 8);
}

TEST(RankCost, GrowingPlatesKeepTheirEfficiency) {
  SharedPlate of_one = plate;
  of_one.rows = 1000.0;
  const double few = weak_efficiency(of_one, 4, fast), many = weak_efficiency(of_one, 4096, fast);
  EXPECT_GT(few, 0.98);
  EXPECT_GT(many, 0.97);
  EXPECT_LT(many, few);
}

}  // namespace
}  // namespace hackle
