// SPDX-License-Identifier: MIT
#include "lattice/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "lattice/lattice.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Grid square(int nodes, double dx = 0.5e-3) {
  Plate plate;
  plate.width = plate.height = nodes * dx;
  return make_grid(plate, dx);
}

struct Moments {
  double mean = 0.0, deviation = 0.0;
};

Moments moments(const std::vector<float>& values) {
  Moments result;
  for (const float v : values) result.mean += v;
  result.mean /= static_cast<double>(values.size());
  for (const float v : values) result.deviation += (v - result.mean) * (v - result.mean);
  result.deviation = std::sqrt(result.deviation / static_cast<double>(values.size()));
  return result;
}

double weibull_deviation(double k) {
  const double mean = std::tgamma(1.0 + 1.0 / k);
  return std::sqrt(std::tgamma(1.0 + 2.0 / k) - mean * mean) / mean;
}

// Five standard errors: sigma/sqrt(N) of a mean, and sigma sqrt((kurtosis - 1)/4N) of a deviation,
// with the kurtosis below 9 (that of k = 1).
constexpr int side = 200;
const double mean_error = 5.0 / side, deviation_error = 5.0 * std::sqrt(2.0) / side;

TEST(Scatter, WeibullHasMeanOneAndTheSpreadOfItsModulus) {
  for (const double k : {1.0, 3.0, 10.0, 50.0}) {
    const double sigma = weibull_deviation(k);
    const Moments m = moments(strengths({Scatter::Kind::weibull, k, 0.0, 3}, square(side)));
    EXPECT_NEAR(m.mean, 1.0, mean_error * sigma) << k;
    EXPECT_NEAR(m.deviation, sigma, deviation_error * sigma) << k;
  }
}

// Moving the values beyond 3 deviations to 3 reduces the deviation by 0.25 %.
TEST(Scatter, NormalHasMeanOneAndStaysWithinThreeDeviations) {
  const std::vector<float> values = strengths({Scatter::Kind::normal, 0.3, 0.0, 3}, square(side));
  const Moments m = moments(values);
  EXPECT_NEAR(m.mean, 1.0, mean_error * 0.3);
  EXPECT_NEAR(m.deviation, 0.3 * 0.9975, 0.3 * 5.0 / (std::sqrt(2.0) * side));
  EXPECT_GE(*std::ranges::min_element(values), 0.1F);
  EXPECT_LE(*std::ranges::max_element(values), 1.9F);
}

// A share p of N falls below the quantile, give or take 5 sqrt(p (1 - p)/N).
TEST(Scatter, QuantilesAreThoseOfWeibull) {
  const double k = 8.0, scale = 1.0 / std::tgamma(1.0 + 1.0 / k);
  const std::vector<float> values = strengths({Scatter::Kind::weibull, k, 0.0, 5}, square(side));
  for (const double p : {0.01, 0.1, 0.5, 0.9, 0.99}) {
    const double quantile = scale * std::pow(-std::log1p(-p), 1.0 / k);
    const auto below = std::ranges::count_if(values, [&](float v) { return v < quantile; });
    EXPECT_NEAR(static_cast<double>(below) / (side * side), p,
                5.0 * std::sqrt(p * (1.0 - p)) / side);
  }
}

// Returns the correlation of nodes n apart along x and y.
double correlation(const std::vector<float>& values, int n) {
  const Moments m = moments(values);
  double sum = 0.0, count = 0.0;
  for (int j = 0; j + n < side; ++j)
    for (int i = 0; i + n < side; ++i) {
      const auto at = [&](int a, int b) { return values[b * side + a] - m.mean; };
      sum += at(i, j) * at(i + n, j) + at(i, j) * at(i, j + n);
      count += 2.0;
    }
  return sum / (count * m.deviation * m.deviation);
}

// Over a side of 50 L there are 50^2/pi = 800 flaws: five standard errors are 0.18, of the mean
// 0.18 deviations.
TEST(Scatter, NeighboursAreCorrelatedOverTheLength) {
  const double dx = 0.5e-3, L = 4 * dx, error = 5.0 / std::sqrt(800.0);
  const std::vector<float> values = strengths({Scatter::Kind::normal, 0.1, L, 1}, square(side, dx));
  const Moments m = moments(values);
  EXPECT_NEAR(m.mean, 1.0, error * 0.1);
  EXPECT_NEAR(m.deviation, 0.1, error * 0.1);
  EXPECT_NEAR(correlation(values, 2), std::exp(-0.25), error);
  EXPECT_NEAR(correlation(values, 4), std::exp(-1.0), error);
  EXPECT_NEAR(correlation(values, 12), 0.0, error);
}

// Every node of the coarse lattice coincides with a node of one three times as fine.
TEST(Scatter, EverySpacingSeesTheSameFlaws) {
  const Scatter scatter{Scatter::Kind::weibull, 10.0, 2e-3, 7};
  const Grid coarse = square(40, 0.6e-3), fine = square(120, 0.2e-3);
  const std::vector<float> few = strengths(scatter, coarse), many = strengths(scatter, fine);
  for (int j = 0; j < coarse.ny; ++j)
    for (int i = 0; i < coarse.nx; ++i)
      ASSERT_NEAR(few[coarse.index(i, j)], many[fine.index(3 * i + 1, 3 * j + 1)], 1e-6);
}

TEST(Scatter, AnotherSeedGivesOtherFlawsAndTheSameSeedTheSame) {
  const auto values = [](std::int64_t seed, double L) {
    return strengths({Scatter::Kind::weibull, 10.0, L, seed}, square(30));
  };
  for (const double L : {0.0, 2e-3}) {
    EXPECT_EQ(values(1, L), values(1, L));
    EXPECT_NE(values(1, L), values(2, L));
    EXPECT_NE(values(1, L), values(-1, L));
  }
}

TEST(Scatter, ExtremesArePositiveAndFinite) {
  for (const Scatter& scatter :
       {Scatter{Scatter::Kind::weibull, 1.0, 0.0, 1}, Scatter{Scatter::Kind::weibull, 1e3, 1e6, 1},
        Scatter{Scatter::Kind::weibull, 5.0, 1e-300, 1},
        Scatter{Scatter::Kind::weibull, 5.0, 0.26e-3, 1},
        Scatter{Scatter::Kind::normal, 0.3, 1e300, std::numeric_limits<std::int64_t>::min()}})
    for (const float v : strengths(scatter, square(50)))
      ASSERT_TRUE(v >= static_cast<float>(min_strength) && v < 50.0F) << v;
}

TEST(Scatter, BitsAreTheSameOnEveryMachine) {
  const auto bits = [](const Scatter& scatter) {
    const std::vector<float> v = strengths(scatter, square(10));
    char text[80];
    std::snprintf(text, sizeof text, "%a %a %a", v[0], v[37], v[99]);
    return std::string(text);
  };
  EXPECT_EQ(bits({Scatter::Kind::weibull, 10.0, 0.0, 1}),
            "0x1.0b7e6cp+0 0x1.07e15ep+0 0x1.09aeaep+0");
  EXPECT_EQ(bits({Scatter::Kind::weibull, 10.0, 2e-3, 1}),
            "0x1.0d9ff8p+0 0x1.179e58p+0 0x1.1fd744p+0");
  EXPECT_EQ(bits({Scatter::Kind::normal, 0.1, 0.0, 1}), "0x1.072a82p+0 0x1.03e7bp+0 0x1.0584dap+0");
}

TEST(Scatter, APlateCarriesItToTheLattice) {
  Plate plate = test::bare_plate(20, 20);
  EXPECT_TRUE(Lattice(plate, test::numerics()).strength.empty());
  plate.scatter = Scatter{Scatter::Kind::weibull, 10.0, 0.0, 1};
  const Lattice lattice(plate, test::numerics());
  EXPECT_EQ(lattice.strength, strengths(*plate.scatter, lattice.grid));
}

}  // namespace
}  // namespace hackle
