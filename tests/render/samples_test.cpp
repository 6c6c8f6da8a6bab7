// SPDX-License-Identifier: MIT
#include "render/samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

Grid cells_of(int nx, int ny) {
  return {nx, ny, 1e-3, {0.5e-3 * nx, 0.5e-3 * ny}};
}

TEST(Under, PointsCoverEveryCellAndAreMirrorImages) {
  for (const auto& [points, cells] :
       {std::pair{1, 1}, {1, 7}, {7, 1}, {640, 4000}, {1200, 800}, {1201, 800}, {16384, 16383}}) {
    int next = 0;
    for (int k = 0; k < points; ++k) {
      const Under here = under(k, points, cells), there = under(points - 1 - k, points, cells);
      EXPECT_LE(here.first, next);  // no cell is left out
      next = here.last + 1;
      EXPECT_EQ(here.first, cells - 1 - there.last) << k;
      EXPECT_EQ(here.last, cells - 1 - there.first) << k;
    }
    EXPECT_EQ(next, cells);
  }
}

TEST(Samples, OfOnePointACellAreTheCells) {
  const Grid g = cells_of(5, 3);
  std::vector<float> values(g.nodes());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<float>(k);
  for (const Sampling sampling : {Sampling::largest, Sampling::mean})
    EXPECT_EQ(samples(values, g, {0, 0, 5, 3}, 5, 3, sampling), values);
}

// Compares with loops over all cells, for windows inside, across and beyond the lattice.
TEST(Samples, AreTheLargestOrTheMeanOfTheNumbersUnderThem) {
  std::mt19937 random(7);
  const Grid g = cells_of(31, 17);
  std::vector<float> values(g.nodes());
  for (float& value : values)
    value = random() % 5 == 0 ? no_value : static_cast<float>(random() % 1000) - 500.0F;
  for (const Window window :
       {Window{0, 0, 31, 17}, {-9, 4, 40, 9}, {20, 10, 30, 30}, {3, 3, 2, 2}}) {
    const int width = 11, height = 6;
    const auto max = samples(values, g, window, width, height, Sampling::largest);
    const auto mean = samples(values, g, window, width, height, Sampling::mean);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        std::vector<double> seen;
        const Under rows = under(y, height, window.ny), columns = under(x, width, window.nx);
        for (int j = rows.first; j <= rows.last; ++j)
          for (int i = columns.first; i <= columns.last; ++i) {
            if (!g.contains(window.left + i, window.bottom + j)) continue;
            const float value = values[g.index(window.left + i, window.bottom + j)];
            if (!std::isnan(value)) seen.push_back(value);
          }
        const auto at = static_cast<std::size_t>(y * width + x);
        ASSERT_EQ(std::isnan(max[at]), seen.empty());
        ASSERT_EQ(std::isnan(mean[at]), seen.empty());
        if (seen.empty()) continue;
        double sum = 0.0;
        for (const double value : seen) sum += value;
        EXPECT_EQ(max[at], *std::ranges::max_element(seen));
        // Sums of integers are exact.
        EXPECT_EQ(mean[at], static_cast<float>(sum / static_cast<double>(seen.size())));
      }
  }
}

TEST(Samples, OfDamageAreTheMostDamage) {
  const Grid g = cells_of(4, 4);
  std::vector<std::uint8_t> damage(g.nodes());
  damage[g.index(2, 1)] = 200;
  const auto seen = samples(damage, g, {0, 0, 4, 4}, 2, 2);
  EXPECT_EQ(seen, (std::vector<std::uint8_t>{0, 200, 0, 0}));
}

}  // namespace
}  // namespace hackle
