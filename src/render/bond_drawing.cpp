// SPDX-License-Identifier: MIT
#include "render/bond_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hackle {
namespace {

// Legible on any colour of a field.
constexpr Colour holding{255, 255, 255}, broken{235, 70, 60}, rim{0, 0, 0};
constexpr double opacity_of_holding = 0.35, opacity_of_broken = 0.8;

// Returns the visible position of node (i, j), px.
Vec2 place_of(int i, int j, const Grid& grid, const Displaced& displaced, const Camera& camera) {
  Vec2 cells(i + 0.5, j + 0.5);
  if (!displaced.displacement.empty()) {
    const float* u = &displaced.displacement[2 * grid.index(i, j)];
    cells += displaced.magnification / grid.dx * Vec2(u[0], u[1]);
  }
  return camera.pixel_of_cells(cells);
}

// Returns the visible positions of the nodes that are not void, px.
std::vector<Vec2> places_of(const DrawnNodes& nodes, const Grid& grid, const Displaced& displaced,
                            const Camera& camera) {
  std::vector<Vec2> places;
  const Window& cells = nodes.cells;
  for (int j = std::max(cells.bottom, 0); j < std::min(cells.bottom + cells.ny, grid.ny); ++j)
    for (int i = std::max(cells.left, 0); i < std::min(cells.left + cells.nx, grid.nx); ++i)
      if (!std::isnan(nodes.values[grid.index(i, j)]))
        places.push_back(place_of(i, j, grid, displaced, camera));
  return places;
}

}  // namespace

void draw_bonds(Canvas& canvas, const std::vector<BondLine>& bonds, const DrawnNodes& nodes,
                const Grid& grid, const Displaced& displaced, const Camera& camera,
                const Rectangle& plate) {
  const double cell = camera.pixels_a_metre().x() * grid.dx;
  const double width = std::clamp(0.02 * cell, 0.6, 3.0);
  canvas.within(plate, [&] {
    for (const BondLine& bond : bonds) {
      const std::array ends{
          place_of(bond.i, bond.j, grid, displaced, camera),
          place_of(bond.i + bond.column, bond.j + bond.row, grid, displaced, camera)};
      canvas.colour(bond.holds ? holding : broken,
                    bond.holds ? opacity_of_holding : opacity_of_broken);
      canvas.line(ends, width);
    }
    const double radius = std::clamp(0.1 * cell, 1.5, 12.0);
    for (const Vec2& node : places_of(nodes, grid, displaced, camera)) {
      canvas.colour(rim);
      canvas.dot(node, radius + 1.0);
      canvas.colour(holding);
      canvas.dot(node, radius);
    }
  });
}

}  // namespace hackle
