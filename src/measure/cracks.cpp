// SPDX-License-Identifier: MIT
#include "measure/cracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hackle {
namespace {

bool holds(const Box& box, const Vec2& point) {
  return (point.array() >= box.min.array()).all() && (point.array() <= box.max.array()).all();
}

void widen(Cracks& found, const Vec2& place) {
  if (found.nodes++ == 0) found.box = {place, place};
  found.box = {found.box.min.cwiseMin(place), found.box.max.cwiseMax(place)};
}

}  // namespace

Box everywhere() {
  constexpr double all = std::numeric_limits<double>::infinity();
  return {{-all, -all}, {all, all}};
}

Cracks cracks(const View& view, const Box& area) {
  const Lattice& lattice = view.lattice();
  return cracks(nodes_on_crack(damage(view)), nodes_on_crack(damage_at_start(view)), lattice.grid,
                lattice.family.m(), area);
}

Cracks cracks(Nodes nodes, Nodes at_start, const Grid& grid, double m, const Box& area) {
  Cracks found;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 place = grid.position(i, j);
      const std::size_t node = grid.index(i, j);
      if (!holds(area, place))
        nodes[node] = at_start[node] = 0;
      else if (nodes[node])
        widen(found, place);
    }
  found.bands = max_bands(close_gaps(nodes, grid, m), grid);
  const std::vector<Vec2> places = forks(nodes, at_start, grid, m);
  if (!places.empty()) found.fork = places.front().x();
  return found;
}

std::optional<Vec2> foremost(const Field& damage, const Grid& grid, const Vec2& direction) {
  double max = -std::numeric_limits<double>::infinity();
  Box box{};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (damage.values[grid.index(i, j)] <= on_crack) continue;
      const Vec2 place = grid.from_centre(i, j);
      const double along = direction.dot(place);
      if (along < max - 0.5) continue;
      box = along > max + 0.5 ? Box{place, place}
                              : Box{box.min.cwiseMin(place), box.max.cwiseMax(place)};
      max = std::max(max, along);
    }
  if (std::isinf(max)) return std::nullopt;
  return grid.centre + 0.5 * grid.dx * (box.min + box.max);
}

}  // namespace hackle
