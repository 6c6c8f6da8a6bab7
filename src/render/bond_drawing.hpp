// SPDX-License-Identifier: MIT
// Draws the lattice itself: bonds as lines, nodes as dots.
#pragma once

#include <span>
#include <vector>

#include "measure/bond_lines.hpp"
#include "render/camera.hpp"
#include "render/cell_mesh.hpp"
#include "render/overlay/canvas.hpp"

namespace hackle {

// The largest number of nodes whose bonds are drawn in one picture.
inline constexpr int max_drawn_nodes = 1500;

// The nodes of `cells`; those whose value is nan, by Grid::index, are void.
struct DrawnNodes {
  Window cells;
  std::span<const float> values;
};

// Draws inside the rectangle of the plate; broken bonds have another colour and lie over intact
// ones. Every node has its dot, with or without bonds.
void draw_bonds(Canvas& canvas, const std::vector<BondLine>& bonds, const DrawnNodes& nodes,
                const Grid& grid, const Displaced& displaced, const Camera& camera,
                const Rectangle& plate);

}  // namespace hackle
