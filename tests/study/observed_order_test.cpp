// SPDX-License-Identifier: MIT
// Synthetic solutions f0 + C h^p, whose order is known.
#include "study/observed_order.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gmock/gmock.h>

namespace hackle {
namespace {

std::vector<LevelChange> changes_of(const std::vector<double>& values) {
  std::vector<LevelChange> all;
  for (std::size_t k = 1; k < values.size(); ++k)
    all.push_back({std::abs(values[k] - values[k - 1]), values[k] < values[k - 1] ? -1 : 1});
  return all;
}

std::vector<double> values_at(const std::vector<double>& sizes,
                              const std::function<double(double)>& f) {
  std::vector<double> values;
  for (const double size : sizes) values.push_back(f(size));
  return values;
}

TEST(ObservedOrder, IsThatOfTheSolution) {
  for (const double p : {0.5, 1.0, 2.0})
    for (const std::vector<double>& sizes : {std::vector<double>{4.0, 2.0, 1.0},
                                             {1.0, 1.0 / std::sqrt(2.0), 0.5},
                                             {1.0 / 3.0, 0.25, 1.0 / 6.0, 0.125}}) {
      const auto values = values_at(sizes, [&](double h) { return 7.0 - 3.0 * std::pow(h, p); });
      const ObservedOrder found = observed_order(sizes, changes_of(values));
      EXPECT_EQ(found.trend, Trend::converges);
      ASSERT_TRUE(found.order);
      EXPECT_NEAR(*found.order, p, 1e-9);
      const std::size_t fine = sizes.size() - 1;
      const double ratio = sizes[fine - 1] / sizes[fine];
      EXPECT_NEAR(richardson(values[fine - 1], values[fine], ratio, *found.order), 7.0, 1e-9);
      // The uncertainty is the true error with the factor of safety.
      EXPECT_NEAR(*found.uncertainty, 1.25 * 3.0 * std::pow(sizes[fine], p), 1e-8);
    }
}

TEST(ObservedOrder, DoesNotTrustAHighOne) {
  const std::vector<double> sizes{4.0, 2.0, 1.0};
  const auto values = values_at(sizes, [](double h) { return std::pow(h, 6.0); });
  const ObservedOrder found = observed_order(sizes, changes_of(values));
  EXPECT_NEAR(*found.order, 6.0, 1e-9);
  EXPECT_NEAR(*found.uncertainty, 1.25 * (64.0 - 1.0) / 3.0, 1e-9);  // as of second order
}

TEST(ObservedOrder, SeesWhatOscillates) {
  const std::vector<double> sizes{4.0, 2.0, 1.0};
  const ObservedOrder shrinks = observed_order(sizes, changes_of({1.0, 2.0, 1.5}));
  EXPECT_EQ(shrinks.trend, Trend::oscillates);
  EXPECT_TRUE(shrinks.uncertainty);
  EXPECT_FALSE(shrinks.order);
  const ObservedOrder grows = observed_order(sizes, changes_of({1.0, 2.0, 0.5}));
  EXPECT_EQ(grows.trend, Trend::oscillates);
  EXPECT_FALSE(grows.uncertainty);
}

TEST(ObservedOrder, SeesWhatDiverges) {
  const std::vector<double> sizes{4.0, 2.0, 1.0};
  const auto strength = values_at(sizes, [](double h) { return 5.0 / std::sqrt(h); });
  const ObservedOrder found = observed_order(sizes, changes_of(strength));
  EXPECT_EQ(found.trend, Trend::diverges);
  EXPECT_NEAR(*found.order, -0.5, 1e-9);
  EXPECT_FALSE(found.uncertainty);
  EXPECT_NEAR(*fitted_exponent(sizes, strength), -0.5, 1e-12);
  // The same step at every halving does not shrink either.
  const ObservedOrder drifts = observed_order(sizes, changes_of({0.060, 0.062, 0.064}));
  EXPECT_EQ(drifts.trend, Trend::diverges);
  EXPECT_NEAR(*drifts.per_halving, 0.002, 1e-12);
}

TEST(ObservedOrder, ScalesTheLastChangeToAHalving) {
  const double root = std::sqrt(2.0);
  const std::vector<double> sizes{root * root, root, 1.0};
  const ObservedOrder found = observed_order(sizes, changes_of({3.0, 2.0, 1.0}));
  EXPECT_NEAR(*found.per_halving, 2.0, 1e-12);
}

TEST(ObservedOrder, KnowsWhatCannotBeToldApart) {
  const std::vector<double> sizes{4.0, 2.0, 1.0}, steps{0.4, 0.2, 0.1};
  const auto changes = changes_of({7.0, 7.3, 7.1});
  EXPECT_EQ(observed_order(sizes, changes).trend, Trend::oscillates);
  const ObservedOrder found = observed_order(sizes, changes, steps);
  EXPECT_EQ(found.trend, Trend::constant);
  EXPECT_NEAR(*found.uncertainty, 1.25 * 0.2, 1e-12);
  EXPECT_EQ(observed_order(sizes, changes_of({1.0, 1.0, 1.0})).trend, Trend::constant);
}

TEST(ObservedOrder, SaysLittleOfTwoLevels) {
  const std::vector<double> sizes{2.0, 1.0};
  const ObservedOrder found = observed_order(sizes, changes_of({3.0, 2.0}));
  EXPECT_EQ(found.trend, Trend::unknown);
  EXPECT_NEAR(*found.uncertainty, 3.0, 1e-12);  // as of first order
  EXPECT_FALSE(observed_order({}, {}).uncertainty);
}

TEST(FittedExponent, NeedsPositiveNumbers) {
  const std::vector<double> sizes{2.0, 1.0}, values{1.0, -1.0}, one{1.0};
  EXPECT_FALSE(fitted_exponent(sizes, values));
  EXPECT_FALSE(fitted_exponent(one, one));
}

}  // namespace
}  // namespace hackle
