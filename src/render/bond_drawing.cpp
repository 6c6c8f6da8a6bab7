// SPDX-License-Identifier: MIT
#include "render/bond_drawing.hpp"

#include <algorithm>
#include <array>

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

}  // namespace

void draw_bonds(Canvas& canvas, const std::vector<BondLine>& bonds, const Grid& grid,
                const Displaced& displaced, const Camera& camera, const Rectangle& plate) {
  if (bonds.empty()) return;
  const double cell = camera.pixels_a_metre().x() * grid.dx;
  const double width = std::clamp(0.02 * cell, 0.6, 3.0);
  canvas.clip(plate);
  for (const BondLine& bond : bonds) {
    const std::array ends{
        place_of(bond.i, bond.j, grid, displaced, camera),
        place_of(bond.i + bond.column, bond.j + bond.row, grid, displaced, camera)};
    canvas.colour(bond.holds ? holding : broken,
                  bond.holds ? opacity_of_holding : opacity_of_broken);
    canvas.line(ends, width);
  }
  const double radius = std::clamp(0.1 * cell, 1.5, 12.0);
  for (const BondLine& bond : bonds) {
    if (bond.column != 0 || bond.row != 1) continue;  // once per node
    const Vec2 node = place_of(bond.i, bond.j, grid, displaced, camera);
    canvas.colour(rim);
    canvas.dot(node, radius + 1.0);
    canvas.colour(holding);
    canvas.dot(node, radius);
  }
}

}  // namespace hackle
