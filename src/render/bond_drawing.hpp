// SPDX-License-Identifier: MIT
// The lattice itself: bonds as lines, nodes as dots.
#pragma once

#include <span>
#include <vector>

#include "measure/bond_lines.hpp"
#include "render/camera.hpp"
#include "render/canvas.hpp"
#include "render/cell_mesh.hpp"

namespace hackle {

// Nodes of which bonds are drawn in one picture, at most.
inline constexpr int max_drawn_nodes = 1500;

// Inside of the rectangle of the plate; broken bonds in another colour, over those that hold.
void draw_bonds(Canvas& canvas, const std::vector<BondLine>& bonds, const Grid& grid,
                const Displaced& displaced, const Camera& camera, const Rectangle& plate);

}  // namespace hackle
