// SPDX-License-Identifier: MIT
#include "study/path_distance.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hackle {
namespace {

using Lines = std::vector<std::vector<Vec2>>;

TEST(HausdorffDistance, OfParallelLinesIsTheirDistance) {
  const Lines one{{{0, 0}, {1, 0}, {2, 0}}}, other{{{0, 0.5}, {2, 0.5}}};
  EXPECT_DOUBLE_EQ(hausdorff_distance(one, other), 0.5);
}

TEST(HausdorffDistance, SeesABranchThatTheOtherLacks) {
  const Lines straight{{{0, 0}, {2, 0}}};
  const Lines forked{{{0, 0}, {2, 0}}, {{1, 0}, {1.6, 0.8}}};
  EXPECT_DOUBLE_EQ(hausdorff_distance(straight, forked), 0.8);
  EXPECT_DOUBLE_EQ(hausdorff_distance(forked, straight), 0.8);
}

TEST(HausdorffDistance, DoesNotDependOnHowDenselyALineIsSampled) {
  Lines dense{{}};
  for (int k = 0; k <= 1000; ++k) dense[0].emplace_back(0.003 * k, 0.001 * k);
  const Lines sparse{{{0, 0}, {3, 1}}};
  EXPECT_NEAR(hausdorff_distance(dense, sparse), 0.0, 1e-15);
}

TEST(HausdorffDistance, TakesAPointForALine) {
  EXPECT_DOUBLE_EQ(hausdorff_distance({{{0, 0}}}, {{{3, 4}}}), 5.0);
}

TEST(HausdorffDistance, OfALongerCrackIsWhatIsAhead) {
  EXPECT_DOUBLE_EQ(hausdorff_distance({{{0, 0}, {1, 0}}}, {{{0, 0}, {1.25, 0}}}), 0.25);
}

}  // namespace
}  // namespace hackle
