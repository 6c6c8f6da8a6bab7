// SPDX-License-Identifier: MIT
#include "lattice/scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "base/portable_math.hpp"
#include "lattice/carve.hpp"

namespace hackle {
namespace {

// SplitMix64 (Steele, Lea & Flood 2014): neighbouring inputs give unrelated bits.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

// Returns a number in (-1, 1): an odd multiple of 2^-52, hence never 0.
double centred(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-51 - 1.0;
}

// Weights of 2 reach + 1 cells around a place: a Gaussian of standard deviation 1 cell, which is
// 4e-6 beyond 5 cells.
constexpr int reach = 5;
struct Bell {
  std::int64_t first = 0;
  std::array<double, 2 * reach + 1> weight{};  // sum of squares 1

  explicit Bell(double place) {
    const double nearest = std::floor(place + 0.5);
    first = static_cast<std::int64_t>(nearest) - reach;
    double squares = 0.0;
    for (std::size_t n = 0; n < weight.size(); ++n) {
      const double away = place - (nearest - reach + static_cast<double>(n));
      const double w = portable::exp(-0.5 * (away * away));
      weight[n] = w;
      squares += w * w;
    }
    for (double& w : weight) w /= std::sqrt(squares);
  }
};

// Rows of noise around the current row of nodes.
class NoiseRows {
 public:
  NoiseRows(std::int64_t seed, std::int64_t first_column, std::size_t columns)
      : seed_(seed), first_column_(first_column), columns_(columns) {}

  // Moves only upwards: rows must be requested in ascending order.
  void move_to(std::int64_t first_row) {
    while (!rows_.empty() && first_row_ < first_row) {
      rows_.pop_front();
      ++first_row_;
    }
    if (rows_.empty()) first_row_ = first_row;
    while (rows_.size() < 2 * reach + 1) rows_.push_back(make_row(first_row_ + std::ssize(rows_)));
  }

  std::vector<double> weighted(const Bell& bell) const {
    std::vector<double> sum(columns_);
    for (std::size_t k = 0; k < bell.weight.size(); ++k)
      for (std::size_t c = 0; c < columns_; ++c) sum[c] += bell.weight[k] * rows_[k][c];
    return sum;
  }

 private:
  std::vector<double> make_row(std::int64_t row) const {
    std::vector<double> values(columns_);
    for (std::size_t c = 0; c < columns_; ++c)
      values[c] = normal_noise(seed_, first_column_ + static_cast<std::int64_t>(c), row);
    return values;
  }

  std::int64_t seed_, first_column_, first_row_ = 0;
  std::size_t columns_;
  std::deque<std::vector<double>> rows_;
};

// Calls take(node, g) with a standard normal random number g for every node.
template <class Take>
void for_correlated(const Scatter& scatter, const Grid& grid, const Take& take) {
  const double cell = 0.5 * scatter.correlation;
  std::vector<Bell> across;
  across.reserve(static_cast<std::size_t>(grid.nx));
  for (int i = 0; i < grid.nx; ++i) across.emplace_back(grid.position(i, 0).x() / cell);
  const std::int64_t first = across.front().first;
  const auto columns = static_cast<std::size_t>(across.back().first - first + 2LL * reach + 1);
  NoiseRows noise(scatter.seed, first, columns);
  for (int j = 0; j < grid.ny; ++j) {
    throw_if_interrupted();
    const Bell up(grid.position(0, j).y() / cell);
    noise.move_to(up.first);
    const std::vector<double> sums = noise.weighted(up);
    for (int i = 0; i < grid.nx; ++i) {
      const Bell& bell = across[static_cast<std::size_t>(i)];
      double g = 0.0;
      for (std::size_t k = 0; k < bell.weight.size(); ++k)
        g += bell.weight[k] * sums[static_cast<std::size_t>(bell.first - first) + k];
      take(grid.index(i, j), g);
    }
  }
}

template <class Take>
void for_independent(const Scatter& scatter, const Grid& grid, const Take& take) {
  for_nodes(grid, [&](int i, int j) { take(grid.index(i, j), normal_noise(scatter.seed, i, j)); });
}

// Returns the Weibull quantile at the probability of g under the standard normal distribution.
double weibull(double g, double modulus) {
  const double below = g < 0.0 ? -portable::log1p(-portable::normal_below(g))
                               : -portable::log(portable::normal_below(-g));
  return portable::exp(portable::log(below) / modulus);
}

}  // namespace

// Uses Marsaglia's polar method, which needs no angles.
double normal_noise(std::int64_t seed, std::int64_t column, std::int64_t row) {
  std::uint64_t bits =
      mixed(mixed(mixed(static_cast<std::uint64_t>(seed)) ^ static_cast<std::uint64_t>(column)) ^
            static_cast<std::uint64_t>(row));
  for (;;) {
    const double x = centred(bits = mixed(bits)), y = centred(bits = mixed(bits));
    const double square = x * x + y * y;
    if (square < 1.0) return x * std::sqrt(-2.0 * portable::log(square) / square);
  }
}

std::vector<float> strengths(const Scatter& scatter, const Grid& grid) {
  std::vector<float> result(grid.nodes());
  const bool is_weibull = scatter.kind == Scatter::Kind::weibull;
  const double mean = is_weibull ? portable::gamma(1.0 + 1.0 / scatter.spread) : 1.0;
  const auto take = [&](std::size_t node, double g) {
    const double factor =
        is_weibull
            ? std::max(weibull(std::clamp(g, -8.0, 8.0), scatter.spread) / mean, min_strength)
            : 1.0 + scatter.spread * std::clamp(g, -3.0, 3.0);
    result[node] = static_cast<float>(factor);
  };
  if (scatter.correlation < 0.5 * grid.dx)
    for_independent(scatter, grid, take);
  else
    for_correlated(scatter, grid, take);
  return result;
}

}  // namespace hackle
