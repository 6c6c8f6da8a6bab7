// SPDX-License-Identifier: MIT
#include "measure/crack_bands.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

struct Offset {
  int column = 0;
  int row = 0;
};

std::vector<Offset> disc(double radius) {
  std::vector<Offset> offsets;
  const int reach = static_cast<int>(std::floor(radius));
  for (int b = -reach; b <= reach; ++b)
    for (int a = -reach; a <= reach; ++a)
      if (a * a + b * b <= radius * radius) offsets.push_back({a, b});
  return offsets;
}

template <class Work>
void for_each(const Nodes& nodes, const Grid& grid, Work work) {
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (nodes[grid.index(i, j)]) work(i, j);
}

}  // namespace

Nodes nodes_on_crack(const Field& damage) {
  Nodes nodes(damage.values.size());
  std::ranges::transform(damage.values, nodes.begin(),
                         [](float value) { return static_cast<char>(value > on_crack); });
  return nodes;
}

// A morphological closing: the area covered by discs about the nodes, minus the area covered by
// discs outside that. The outside of the plate removes nothing.
Nodes close_gaps(const Nodes& nodes, const Grid& grid, double reach) {
  const std::vector<Offset> brush = disc(0.5 * reach);
  Nodes wide(nodes.size());
  for_each(nodes, grid, [&](int i, int j) {
    for (const auto& [a, b] : brush)
      if (grid.contains(i + a, j + b)) wide[grid.index(i + a, j + b)] = 1;
  });
  Nodes closed = wide;
  for_each(wide, grid, [&](int i, int j) {
    closed[grid.index(i, j)] = static_cast<char>(std::ranges::all_of(brush, [&](const Offset& to) {
      const int k = i + to.column, l = j + to.row;
      return !grid.contains(k, l) || wide[grid.index(k, l)];
    }));
  });
  return closed;
}

int bands(const Nodes& nodes, const Grid& grid, int column) {
  int count = 0;
  bool inside = false;
  for (int j = 0; j < grid.ny; ++j) {
    const bool on = nodes[grid.index(column, j)] != 0;
    count += on && !inside ? 1 : 0;
    inside = on;
  }
  return count;
}

int max_bands(const Nodes& nodes, const Grid& grid) {
  int max = 0;
  for (int i = 0; i < grid.nx; ++i) max = std::max(max, bands(nodes, grid, i));
  return max;
}

double tip_place(const Nodes& nodes, const Grid& grid) {
  double farthest = 0.0;
  for_each(nodes, grid,
           [&](int i, int j) { farthest = std::max(farthest, grid.position(i, j).x()); });
  return farthest;
}

}  // namespace hackle
