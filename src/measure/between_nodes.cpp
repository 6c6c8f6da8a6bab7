// SPDX-License-Identifier: MIT
#include "measure/between_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

// The corner that begins the cell of a coordinate, counted from the first node, and the way into
// it.
struct Step {
  int first = 0;
  double way = 0.0;  // 0..1, beyond near the rim
};

Step step_of(double coordinate, int count) {
  if (count == 1) return {0, 0.0};
  const double begin = std::clamp(std::floor(coordinate), 0.0, count - 2.0);
  return {static_cast<int>(begin), coordinate - begin};
}

std::array<Surrounding::Share, 4> corners(const Step& x, const Step& y) {
  return {{{x.first, y.first, (1.0 - x.way) * (1.0 - y.way)},
           {x.first + 1, y.first, x.way * (1.0 - y.way)},
           {x.first, y.first + 1, (1.0 - x.way) * y.way},
           {x.first + 1, y.first + 1, x.way * y.way}}};
}

using Corners = std::array<Surrounding::Share, 4>;

bool exists(const Joints& joints, const Surrounding::Share& corner) {
  return joints.grid.contains(corner.i, corner.j) && joints.is_there(corner.i, corner.j);
}

// Returns whether a corner is the nearest one, or joined to it.
bool is_with(const Joints& joints, const Surrounding::Share& nearest,
             const Surrounding::Share& corner) {
  if (!exists(joints, corner)) return false;
  if (corner.i == nearest.i && corner.j == nearest.j) return true;
  return joints.joined(nearest.i, nearest.j, corner.i - nearest.i, corner.j - nearest.j);
}

// Returns the corner of the largest share that is not in a hole.
std::optional<Surrounding::Share> nearest_of(const Joints& joints, const Corners& all) {
  std::optional<Surrounding::Share> best;
  for (const auto& corner : all)
    if (exists(joints, corner) && (!best || corner.weight > best->weight)) best = corner;
  return best;
}

// Keeps the corners that are with the nearest; their shares add up to 1.
Surrounding one_side(const Joints& joints, const Surrounding::Share& nearest, const Corners& all) {
  Surrounding nodes;
  double sum = 0.0;
  for (const auto& corner : all) {
    if (!is_with(joints, nearest, corner)) continue;
    nodes.shares[static_cast<std::size_t>(nodes.count++)] = corner;
    sum += corner.weight;
  }
  for (int k = 0; k < nodes.count; ++k) nodes.shares[static_cast<std::size_t>(k)].weight /= sum;
  return nodes;
}

// Returns whether a place, in cells from the lower left corner, lies in the cell of a node.
bool is_on_plate(const Joints& joints, const Vec2& at) {
  constexpr double rounding = 1e-9;
  const Grid& grid = joints.grid;
  if (!(at.x() >= -rounding && at.y() >= -rounding && at.x() <= grid.nx + rounding &&
        at.y() <= grid.ny + rounding))
    return false;
  return joints.is_there(std::clamp(static_cast<int>(at.x()), 0, grid.nx - 1),
                         std::clamp(static_cast<int>(at.y()), 0, grid.ny - 1));
}

}  // namespace

std::optional<Surrounding> surrounding(const Joints& joints, const Vec2& place) {
  const Grid& grid = joints.grid;
  const Vec2 at = grid.from_centre(place) + 0.5 * Vec2(grid.nx, grid.ny);
  if (!is_on_plate(joints, at)) return std::nullopt;
  Step x = step_of(at.x() - 0.5, grid.nx), y = step_of(at.y() - 0.5, grid.ny);
  const Corners all = corners(x, y);
  const auto nearest = nearest_of(joints, all);
  if (!nearest) return std::nullopt;
  if (std::ranges::all_of(all, [&](const auto& one) { return is_with(joints, *nearest, one); }))
    return Surrounding{all, 4};
  x.way = std::clamp(x.way, 0.0, 1.0);
  y.way = std::clamp(y.way, 0.0, 1.0);
  return one_side(joints, *nearest, corners(x, y));
}

std::optional<Surrounding> surrounding(const View& view, const Vec2& place) {
  const Lattice& lattice = view.lattice();
  return surrounding(
      {lattice.grid, [&](int i, int j) { return !lattice.is_void(i, j); },
       [&](int i, int j, int column, int row) { return view.holds(i, j, column, row); }},
      place);
}

}  // namespace hackle
