// SPDX-License-Identifier: MIT
#include "render/samples.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace hackle {
namespace {

// The largest value; -infinity without any. nan compares false.
struct Largest {
  using Value = float;
  static constexpr float none = -std::numeric_limits<float>::infinity();
  float sum = none;
  void add(float value) { sum = value > sum ? value : sum; }
  void add(const Largest& other) { add(other.sum); }
  float result() const { return sum == none ? std::numeric_limits<float>::quiet_NaN() : sum; }
};

struct Mean {
  using Value = float;
  double sum = 0.0;
  int count = 0;
  void add(float value) {
    const bool is_number = value == value;
    sum += is_number ? static_cast<double>(value) : 0.0;
    count += is_number ? 1 : 0;
  }
  void add(const Mean& other) {
    sum += other.sum;
    count += other.count;
  }
  float result() const {
    return count == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(sum / count);
  }
};

struct LargestByte {
  using Value = std::uint8_t;
  std::uint8_t sum = 0;
  void add(std::uint8_t value) { sum = std::max(sum, value); }
  void add(const LargestByte& other) { add(other.sum); }
  std::uint8_t result() const { return sum; }
};

// Returns, for each of `points` spread over `cells` columns or rows from `begin` on, the part under
// it that lies among `count` of the lattice; empty if last < first.
std::vector<Under> all_under(int points, int cells, int begin, int count) {
  std::vector<Under> list;
  list.reserve(static_cast<std::size_t>(points));
  for (int k = 0; k < points; ++k) {
    const Under seen = under(k, points, cells);
    list.push_back({std::max(seen.first + begin, 0), std::min(seen.last + begin, count - 1)});
  }
  return list;
}

// Combines the rows under a point first, column by column, then its columns.
template <class Sum>
std::vector<typename Sum::Value> all_samples(std::span<const typename Sum::Value> values,
                                             const Grid& grid, const Window& window, int width,
                                             int height) {
  const std::vector<Under> across = all_under(width, window.nx, window.left, grid.nx);
  std::vector<Sum> columns(static_cast<std::size_t>(grid.nx));
  const auto sum_of = [&](const Under& cells) {
    Sum sum;
    for (int i = cells.first; i <= cells.last; ++i) sum.add(columns[static_cast<std::size_t>(i)]);
    return sum.result();
  };
  std::vector<typename Sum::Value> points;
  points.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const Under& rows : all_under(height, window.ny, window.bottom, grid.ny)) {
    std::ranges::fill(columns, Sum());
    for (int j = rows.first; j <= rows.last; ++j) {
      const auto* value = &values[grid.index(0, j)];
      for (Sum& column : columns) column.add(*value++);
    }
    std::ranges::transform(across, std::back_inserter(points), sum_of);
  }
  return points;
}

}  // namespace

Under under(int k, int points, int cells) {
  const std::int64_t at = static_cast<std::int64_t>(k) * cells;
  return {static_cast<int>(at / points), static_cast<int>((at + cells - 1) / points)};
}

std::vector<float> samples(std::span<const float> values, const Grid& grid, const Window& window,
                           int width, int height, Sampling sampling) {
  if (sampling == Sampling::largest)
    return all_samples<Largest>(values, grid, window, width, height);
  return all_samples<Mean>(values, grid, window, width, height);
}

std::vector<std::uint8_t> samples(std::span<const std::uint8_t> values, const Grid& grid,
                                  const Window& window, int width, int height) {
  return all_samples<LargestByte>(values, grid, window, width, height);
}

}  // namespace hackle
