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

// Draws inside the rectangle of the plate; broken bonds have another colour and lie over intact
// ones.
void draw_bonds(Canvas& canvas, const std::vector<BondLine>& bonds, const Grid& grid,
                const Displaced& displaced, const Camera& camera, const Rectangle& plate);

}  // namespace hackle
