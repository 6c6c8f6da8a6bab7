// SPDX-License-Identifier: MIT
#include "lattice/crack_cut.hpp"

#include <vector>

#include "lattice/carve.hpp"
#include "scene/geometry.hpp"

namespace hackle {
namespace {

// Returns the points of the crack in lattice units.
std::vector<Vec2> on_lattice(const Crack& crack, const Grid& grid) {
  std::vector<Vec2> points;
  for (const Vec2& point : crack.points) points.push_back(grid.from_centre(point));
  return points;
}

template <class Cuts>
void cut_near(const Segment& piece, const Grid& grid, const Family& family, BondBits& bonds,
              const Cuts& cuts) {
  const Box box{piece.from.cwiseMin(piece.to), piece.from.cwiseMax(piece.to)};
  for_nodes(nodes_near(box, grid, family.reach()), [&](int i, int j) {
    family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
      if (cuts(Segment{grid.from_centre(i, j), grid.from_centre(i + a, j + b)}))
        bonds.clear(grid.layout().at(i, j), bit);
    });
  });
}

}  // namespace

void cut(const Crack& crack, const Grid& grid, const Family& family, BondBits& bonds) {
  const std::vector<Vec2> points = on_lattice(crack, grid);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Segment piece{points[k], points[k + 1]};
    cut_near(piece, grid, family, bonds,
             [&](const Segment& bond) { return crosses(piece, bond, tie); });
  }
  const auto cut_at = [&](const Vec2& point) {
    cut_near({point, point}, grid, family, bonds,
             [&](const Segment& bond) { return distance(bond, point) <= tie; });
  };
  for (std::size_t k = 1; k + 1 < points.size(); ++k) cut_at(points[k]);
  const bool closed = points.size() > 2 && crack.points.front() == crack.points.back();
  if (closed || crack.ends == CrackEnds::cut) cut_at(points.front());
  if (crack.ends == CrackEnds::cut) cut_at(points.back());
}

}  // namespace hackle
