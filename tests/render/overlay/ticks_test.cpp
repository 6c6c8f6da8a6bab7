// SPDX-License-Identifier: MIT
#include "render/overlay/ticks.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace hackle {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

constexpr double close = 1e-12;

TEST(Ticks, AreNeatWhateverTheRange) {
  EXPECT_THAT(neat_values(0.0, 0.5, 5),
              Pointwise(DoubleNear(close), {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_THAT(neat_values(-65.0, 65.0, 5), ElementsAre(-50.0, 0.0, 50.0));
  EXPECT_THAT(neat_values(0.123, 0.789, 5), Pointwise(DoubleNear(close), {0.2, 0.4, 0.6}));
}

TEST(Ticks, AreWholeWhereAsked) {
  EXPECT_THAT(whole_values(0.0, 2.3, 5), ElementsAre(0.0, 1.0, 2.0));
  EXPECT_THAT(whole_values(0.0, 12.0, 5), ElementsAre(0.0, 5.0, 10.0));
  EXPECT_THAT(whole_values(-0.4, 0.6, 5), ElementsAre(0.0));
  EXPECT_THAT(whole_values(0.2, 0.6, 5), ElementsAre());
}

TEST(Ticks, NeverMakeMoreIntervalsThanAsked) {
  for (const double min : {-1e300, -7.0, 0.0, 1e-9, 1e9})
    for (const double span : {1e-6, 1.0, 3.7, 1e12, 1e300})
      for (int intervals = 1; intervals < 8; ++intervals) {
        const auto values = neat_values(min, min + span, intervals);
        EXPECT_LE(values.size(), static_cast<std::size_t>(intervals) + 1) << min << " " << span;
      }
}

TEST(Ticks, SurviveTheLargestNumbers) {
  for (const double value : neat_values(-1.7e308, 1.7e308, 5)) EXPECT_TRUE(std::isfinite(value));
}

TEST(Ticks, EncloseARangeWhenAsked) {
  EXPECT_THAT(enclosing_values(0.0, 22.0, 3), ElementsAre(0.0, 10.0, 20.0, 30.0));
  EXPECT_THAT(enclosing_values(-3.0, 12.0, 3), ElementsAre(-5.0, 0.0, 5.0, 10.0, 15.0));
}

TEST(Ticks, DecadesAreThinnedOut) {
  EXPECT_THAT(decades(1.0, 1e4, 12), ElementsAre(1.0, 10.0, 100.0, 1000.0, 10000.0));
  EXPECT_THAT(decades(13.0, 1.3e5, 12), ElementsAre(1e2, 1e3, 1e4, 1e5));
  EXPECT_THAT(decades(1.0, 1e4, 2), ElementsAre(1.0, 100.0, 10000.0));
}

TEST(Ticks, TextsTellNeighboursApart) {
  EXPECT_THAT(tick_texts({0.0, 0.25, 0.5}), ElementsAre("0", "0.25", "0.5"));
  EXPECT_THAT(tick_texts({-20.0, 1e-5, 2.5e12}), ElementsAre("−20", "10⁻⁵", "2.5·10¹²"));
  EXPECT_THAT(tick_texts({1000000.0, 1000000.5}), ElementsAre("1000000", "1000000.5"));
}

}  // namespace
}  // namespace hackle
