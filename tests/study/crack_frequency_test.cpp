// SPDX-License-Identifier: MIT
#include "study/crack_frequency.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "study/told_runs.hpp"

namespace hackle {
namespace {

float share_at(const CrackFrequency& map, double x, double y) {
  const int i = static_cast<int>(1e-3 * x / map.grid.dx);
  const int j = static_cast<int>(1e-3 * y / map.grid.dx);
  return map.share[map.grid.index(i, j)];
}

TEST(CrackFrequency, IsTheShareOfRunsThatCrackedAPlace) {
  const Outcome up = test::told_run({{10, 20, 60, 20, 0, 1}, {60, 20, 90, 10, 1, 2}});
  const Outcome down = test::told_run({{10, 20, 60, 20, 0, 1}});
  const CrackFrequency map = crack_frequency(
      {timed_paths_of(up), timed_paths_of(down), timed_paths_of(down), timed_paths_of(down)},
      up.told["plate"], 1e-3);
  EXPECT_EQ(map.grid.nx, 300);
  EXPECT_EQ(map.grid.ny, 120);
  EXPECT_FLOAT_EQ(share_at(map, 30, 20), 1.0F);
  EXPECT_FLOAT_EQ(share_at(map, 30, 20.7), 1.0F);
  EXPECT_FLOAT_EQ(share_at(map, 30, 21.5), 0.0F);
  EXPECT_FLOAT_EQ(share_at(map, 75, 15), 0.25F);
  EXPECT_TRUE(std::isnan(share_at(map, 75, 30)));  // a hole
}

}  // namespace
}  // namespace hackle
