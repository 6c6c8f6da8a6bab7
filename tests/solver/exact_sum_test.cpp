// SPDX-License-Identifier: MIT
#include "solver/exact_sum.hpp"

#include <algorithm>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace hackle {
namespace {

double sum_of(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

TEST(ExactSum, OfOneOrTwoTermsIsThePlainSum) {
  EXPECT_EQ(sum_of({}), 0.0);
  EXPECT_EQ(sum_of({0.1}), 0.1);
  EXPECT_EQ(sum_of({0.1, 0.7}), 0.1 + 0.7);
  EXPECT_EQ(sum_of({1e300, -1e-300}), 1e300);
}

TEST(ExactSum, LosesNothingBetweenLargeTerms) {
  EXPECT_EQ(sum_of({1e100, 1.0, -1e100}), 1.0);
  EXPECT_EQ(sum_of({1.0, 1e100, 3.0, -1e100}), 4.0);
  EXPECT_EQ(sum_of({0.5, -0.5, 0x1p-1000}), 0x1p-1000);
  // Half a unit in the last place, and a tiny term that decides the direction.
  EXPECT_EQ(sum_of({1.0, 0x1p-53, 0x1p-120}), 1.0 + 0x1p-52);
  EXPECT_EQ(sum_of({1.0, 0x1p-53, -0x1p-120}), 1.0);
}

// Eight integers below 2^60, whose sum is known exactly.
TEST(ExactSum, IsRoundedOnceInEveryOrderAndForBothSigns) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 2000; ++n) {
    std::vector<double> terms;
    std::int64_t whole = 0;
    for (int k = 0; k < 3 + n % 6; ++k) {
      const auto bits = static_cast<std::int64_t>(random() >> 12) - (std::int64_t{1} << 51);
      const auto shift = static_cast<int>(random() % 9);
      whole += bits << shift;
      terms.push_back(std::ldexp(static_cast<double>(bits), shift));
    }
    const auto exact = static_cast<double>(whole);
    for (int turn = 0; turn < 4; ++turn) {
      std::ranges::shuffle(terms, random);
      EXPECT_EQ(sum_of(terms), exact);
      for (double& term : terms) term = -term;
      EXPECT_EQ(sum_of(terms), -exact);
      for (double& term : terms) term = -term;
    }
  }
}

}  // namespace
}  // namespace hackle
