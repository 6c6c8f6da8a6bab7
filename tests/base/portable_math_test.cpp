// SPDX-License-Identifier: MIT
#include "base/portable_math.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hackle {
namespace {

// The argument itself is rounded, hence a relative error of |x| ulps in exp and 1/log in log.
TEST(PortableMath, ExpAgreesWithTheLibrary) {
  for (double x = -690.0; x < 690.0; x += 0.7371)
    EXPECT_NEAR(portable::exp(x) / std::exp(x), 1.0, 2e-15) << x;
}

TEST(PortableMath, LogAgreesWithTheLibrary) {
  for (double x = 1e-300; x < 1e300; x *= 1.7371)
    EXPECT_NEAR(portable::log(x), std::log(x), 5e-16 * (1.0 + std::abs(std::log(x)))) << x;
  for (double x = 1e-300; x < 0.9; x *= 3.1)
    EXPECT_NEAR(portable::log1p(-x) / std::log1p(-x), 1.0, 2e-15) << x;
  EXPECT_EQ(portable::log(1.0), 0.0);
}

TEST(PortableMath, GammaAgreesWithTheLibrary) {
  for (double x = 1.0; x <= 20.0; x += 0.0371)
    EXPECT_NEAR(portable::gamma(x) / std::tgamma(x), 1.0, 5e-14) << x;
}

// 0.5 - erf/2 loses up to 0.5/0.0023 = 200 times the rounding before the fraction takes over.
TEST(PortableMath, NormalDistributionAgreesWithTheLibrary) {
  for (double x = -30.0; x < 10.0; x += 0.00917) {
    const double expected = 0.5 * std::erfc(-x / std::sqrt(2.0));
    EXPECT_NEAR(portable::normal_below(x) / expected, 1.0, 5e-14 + 2e-16 * x * x) << x;
  }
  EXPECT_EQ(portable::normal_below(0.0), 0.5);
}

}  // namespace
}  // namespace hackle
