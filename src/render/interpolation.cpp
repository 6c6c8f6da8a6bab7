// SPDX-License-Identifier: MIT
#include "render/interpolation.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "render/cell_mesh.hpp"

namespace hackle {
namespace {

// A place between two columns or rows of nodes.
struct Between {
  int below = 0;       // the lower of the two
  double share = 0.0;  // of the upper one, 0..1

  int nearest() const { return share > 0.5 ? 1 : 0; }
};

Between between(int point, int points, int cells, int first) {
  const double place = first + (point + 0.5) * cells / points - 0.5;
  const double below = std::floor(place);
  return {static_cast<int>(below), place - below};
}

float point_between(std::span<const float> values, std::span<const std::uint8_t> links,
                    const Grid& grid, const Between& x, const Between& y) {
  const int nearest = x.nearest() + 2 * y.nearest();
  const unsigned joined =
      joined_around(grid, links, x.below + 1, y.below + 1)[static_cast<std::size_t>(nearest)];
  double sum = 0.0, weights = 0.0;
  for (int k = 0; k < around; ++k) {
    const int i = x.below + k % 2, j = y.below + k / 2;
    const float value =
        grid.contains(i, j) ? values[grid.index(i, j)] : std::numeric_limits<float>::quiet_NaN();
    if (k == nearest && std::isnan(value)) return value;
    if ((joined >> k & 1U) == 0 || std::isnan(value)) continue;
    const double weight =
        (k % 2 == 1 ? x.share : 1.0 - x.share) * (k / 2 == 1 ? y.share : 1.0 - y.share);
    sum += weight * static_cast<double>(value);
    weights += weight;
  }
  return static_cast<float>(sum / weights);
}

}  // namespace

std::vector<float> interpolated(std::span<const float> values, std::span<const std::uint8_t> links,
                                const Grid& grid, const Window& window, int width, int height) {
  std::vector<float> points;
  points.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const Between y = between(row, height, window.ny, window.bottom);
    for (int column = 0; column < width; ++column)
      points.push_back(
          point_between(values, links, grid, between(column, width, window.nx, window.left), y));
  }
  return points;
}

}  // namespace hackle
