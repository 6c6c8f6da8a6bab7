// SPDX-License-Identifier: MIT
#include "render/seen_range.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hackle {
namespace {

FieldStyle ranged(double min, double max, bool widens = true) {
  FieldStyle field;
  field.min = min;
  field.max = max;
  field.widens = widens;
  return field;
}

// 1000 values, `large` of them of this size.
std::vector<float> some(int large, float size) {
  std::vector<float> values(1000, 0.5F);
  for (int k = 0; k < large; ++k) values[static_cast<std::size_t>(k)] = size;
  return values;
}

TEST(SeenRange, IsMarkedAtTheEndThatValuesLieBeyond) {
  const FieldStyle field = ranged(0.0, 1.0);
  const auto ends = [&](float value) {
    const Beyond found = beyond(field, {std::vector{0.5F, value}, {}});
    return std::pair(found.below, found.above);
  };
  EXPECT_EQ(ends(0.7F), std::pair(false, false));
  EXPECT_EQ(ends(1.0F), std::pair(false, false));
  EXPECT_EQ(ends(1.01F), std::pair(false, true));
  EXPECT_EQ(ends(-0.01F), std::pair(true, false));
  EXPECT_EQ(ends(std::nanf("")), std::pair(false, false));
  EXPECT_EQ(ends(HUGE_VALF), std::pair(false, true));
}

// Such a cell is painted as a gap, whatever its value.
TEST(SeenRange, WhatLiesInAGapIsNotSeen) {
  const std::vector<float> values{0.5F, 9.0F};
  const std::vector<std::uint8_t> open{0, 102}, nearly{0, 101};
  EXPECT_FALSE(beyond(ranged(0.0, 1.0), {values, open}).above);
  EXPECT_TRUE(beyond(ranged(0.0, 1.0), {values, nearly}).above);
}

TEST(SeenRange, WidensInRoundTimesUntilNinetyNineOfAHundredFit) {
  EXPECT_EQ(widening(ranged(0.0, 1.0), {some(10, 7.0F), {}}), 1.0);
  EXPECT_EQ(widening(ranged(0.0, 1.0), {some(11, 1.5F), {}}), 2.0);
  EXPECT_EQ(widening(ranged(0.0, 1.0), {some(11, 7.0F), {}}), 10.0);
  EXPECT_EQ(widening(ranged(0.0, 1.0), {some(1000, 450.0F), {}}), 500.0);
  EXPECT_EQ(widening(ranged(-1.0, 1.0), {some(11, -3.0F), {}}), 5.0);
  EXPECT_EQ(widening(ranged(0.0, 1.0), {some(1000, -3.0F), {}}), 1.0) << "it begins at 0";
  EXPECT_EQ(widening(ranged(0.0, 1.0, false), {some(1000, 7.0F), {}}), 1.0);
  EXPECT_EQ(widening(ranged(0.0, 1.0), {{}, {}}), 1.0);
}

TEST(SeenRange, WidensAboutZeroOrFromItsLowerEnd) {
  const FieldStyle signs = widened(ranged(-2.0, 3.0), 5.0), one = widened(ranged(1.0, 3.0), 5.0);
  EXPECT_EQ(signs.min, -10.0);
  EXPECT_EQ(signs.max, 15.0);
  EXPECT_EQ(one.min, 1.0);
  EXPECT_EQ(one.max, 11.0);
}

// No range is too small for numbers that are no numbers of use.
TEST(SeenRange, EndsSomewhere) {
  EXPECT_GE(widening(ranged(0.0, 1.0), {some(1000, HUGE_VALF), {}}), 1e9);
}

}  // namespace
}  // namespace hackle
