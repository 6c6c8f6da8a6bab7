// SPDX-License-Identifier: MIT
#include "render/cell_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hackle {
namespace {

using Places = std::array<Vec2, around>;

class Corners {
 public:
  Corners(const Grid& grid, const Displaced& displaced) : grid_(grid), displaced_(displaced) {}

  // Returns the corner between columns i - 1 and i and rows j - 1 and j, in cells from the lower
  // left corner of the lattice, as each surrounding node sees it. Nodes beyond the lattice are
  // ignored.
  Places at(int i, int j) const {
    const Vec2 at_rest(i, j);
    Places places;
    places.fill(at_rest);
    if (displaced_.displacement.empty()) return places;
    const std::array<unsigned, around> group = joined_around(grid_, displaced_.links, i, j);
    for (int k = 0; k < around; ++k)
      places[static_cast<std::size_t>(k)] += mean(i, j, group[static_cast<std::size_t>(k)]);
    return places;
  }

 private:
  bool has(int i, int j) const { return grid_.contains(i, j); }
  // Returns the mean magnified displacement of the nodes in a group, in cells.
  Vec2 mean(int i, int j, unsigned group) const {
    Vec2 sum(0, 0);
    int count = 0;
    for (int k = 0; k < around; ++k) {
      const int column = i - 1 + k % 2, row = j - 1 + k / 2;
      if ((group >> k & 1U) == 0 || !has(column, row)) continue;
      const float* u = &displaced_.displacement[2 * grid_.index(column, row)];
      sum += Vec2(u[0], u[1]);
      ++count;
    }
    return count == 0 ? sum : Vec2(displaced_.magnification / (count * grid_.dx) * sum);
  }

  const Grid& grid_;
  const Displaced& displaced_;
};

// Returns a bound on the magnified displacement, m.
double farthest(const Displaced& displaced) {
  float max = 0.0F;
  for (const float u : displaced.displacement) max = std::max(max, std::abs(u));
  return std::numbers::sqrt2 * displaced.magnification * static_cast<double>(max);
}

}  // namespace

std::array<unsigned, around> joined_around(const Grid& grid, std::span<const std::uint8_t> links,
                                           int i, int j) {
  std::array<unsigned, around> group{1, 2, 4, 8};
  const auto join = [&](std::size_t one, std::size_t other) {
    const unsigned both = group[one] | group[other];
    for (std::size_t k = 0; k < around; ++k)
      if ((both >> k & 1U) != 0) group[k] = both;
  };
  const auto linked = [&](int column, int row, std::uint8_t bit) {
    return grid.contains(column, row) && (links[grid.index(column, row)] & bit) != 0;
  };
  if (linked(i - 1, j - 1, Link::right)) join(0, 1);
  if (linked(i - 1, j, Link::right)) join(2, 3);
  if (linked(i - 1, j - 1, Link::above)) join(0, 2);
  if (linked(i, j - 1, Link::above)) join(1, 3);
  if (linked(i - 1, j - 1, Link::above_right)) join(0, 3);
  if (linked(i, j - 1, Link::above_left)) join(1, 2);
  return group;
}

Blocks blocks_of(const Window& window, const Window& seen, int width, int height) {
  Blocks blocks;
  blocks.size = std::max(1, std::min(seen.nx / std::max(width, 1), seen.ny / std::max(height, 1)));
  blocks.columns = (window.nx + blocks.size - 1) / blocks.size;
  blocks.rows = (window.ny + blocks.size - 1) / blocks.size;
  return blocks;
}

Window seen_cells(const Window& window, double rotation, const Grid& grid,
                  const Displaced& displaced) {
  const double reach = farthest(displaced) / grid.dx + 1.0;
  const Vec2 size = turned_size({window.nx, window.ny}, rotation);
  const double half_x = 0.5 * size.x() + reach, half_y = 0.5 * size.y() + reach;
  const double x = window.left + 0.5 * window.nx, y = window.bottom + 0.5 * window.ny;
  const auto inside = [](double cells, int count) {
    return static_cast<int>(std::clamp(cells, 0.0, static_cast<double>(count)));
  };
  const int left = inside(x - half_x, grid.nx), bottom = inside(y - half_y, grid.ny);
  const int right = inside(std::ceil(x + half_x), grid.nx);
  const int top = inside(std::ceil(y + half_y), grid.ny);
  return {left, bottom, right - left, top - bottom};
}

std::vector<float> corners(const Blocks& blocks, const Window& window, const Grid& grid,
                           const Displaced& displaced, const Camera& camera) {
  std::vector<float> list(8 * blocks.count());
  const Corners lattice(grid, displaced);
  // Corner k of the nodes around it is corner 3 - k of the block to which such a node belongs.
  const auto put = [&](int column, int row, std::size_t corner, const Vec2& place) {
    if (column < 0 || row < 0 || column >= blocks.columns || row >= blocks.rows) return;
    const Vec2 share = camera.share(place);
    const std::size_t block =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks.columns) +
        static_cast<std::size_t>(column);
    list[8 * block + 2 * corner] = static_cast<float>(share.x());
    list[8 * block + 2 * corner + 1] = static_cast<float>(share.y());
  };
  for (int row = 0; row <= blocks.rows; ++row)
    for (int column = 0; column <= blocks.columns; ++column) {
      const int i = std::clamp(window.left + column * blocks.size, 0, grid.nx);
      const int j = std::clamp(window.bottom + row * blocks.size, 0, grid.ny);
      const Places places = lattice.at(i, j);
      for (std::size_t k = 0; k < around; ++k)
        put(column - 1 + static_cast<int>(k % 2), row - 1 + static_cast<int>(k / 2), 3 - k,
            places[k]);
    }
  return list;
}

}  // namespace hackle
