// SPDX-License-Identifier: MIT
#include "study/statistics.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Statistics, KnowsStudentsDistribution) {
  // Abramowitz and Stegun, table 26.10.
  EXPECT_NEAR(student_95(1), 12.706, 5e-4);
  EXPECT_NEAR(student_95(2), 4.303, 5e-4);
  EXPECT_NEAR(student_95(6), 2.447, 5e-4);
  EXPECT_NEAR(student_95(7), 2.365, 7e-4);
  EXPECT_NEAR(student_95(10), 2.228, 5e-4);
  EXPECT_NEAR(student_95(31), 2.040, 6e-4);
  EXPECT_NEAR(student_95(1000000), 1.960, 5e-4);
}

TEST(Statistics, GivesMeanDeviationAndInterval) {
  const std::vector<double> numbers{2, 4, 4, 4, 5, 5, 7, 9};
  const Statistic s = statistic_of(numbers);
  EXPECT_EQ(s.count, 8);
  EXPECT_DOUBLE_EQ(s.mean, 5.0);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt(32.0 / 7.0));
  EXPECT_DOUBLE_EQ(s.min, 2.0);
  EXPECT_DOUBLE_EQ(s.max, 9.0);
  EXPECT_NEAR(s.high - s.mean, 2.3646 * s.sd / std::sqrt(8.0), 2e-3);
  EXPECT_DOUBLE_EQ(s.mean - s.low, s.high - s.mean);
}

TEST(Statistics, OfEqualNumbersIsThatNumber) {
  const std::vector<double> numbers(7, 0.1);
  const Statistic s = statistic_of(numbers);
  EXPECT_EQ(s.mean, 0.1);
  EXPECT_EQ(s.sd, 0.0);
  EXPECT_EQ(s.low, 0.1);
}

TEST(Statistics, OfOneOrNoneHasNoDeviation) {
  const Statistic one = statistic_of(std::vector<double>{3.0});
  EXPECT_EQ(one.mean, 3.0);
  EXPECT_EQ(one.high, 3.0);
  EXPECT_EQ(statistic_of({}).count, 0);
}

}  // namespace
}  // namespace hackle
