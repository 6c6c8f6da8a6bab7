// SPDX-License-Identifier: MIT
// The nodes on cracks, and the bands they make where they lie closer than a bond reaches: what a
// crack leaves behind is as wide as a horizon, not everywhere equally damaged, and frayed.
#pragma once

#include <cstddef>
#include <vector>

#include "lattice/grid.hpp"
#include "measure/field.hpp"

namespace hackle {

// Damage above which a node lies on a crack: a straight crack has 0.4 to 0.5 on its sides.
inline constexpr float on_crack = 0.35F;

// Which nodes, by Grid::index.
using Nodes = std::vector<char>;

Nodes nodes_on_crack(const Field& damage);

// Adds all nodes in gaps of up to about `reach` spacings: those that a disc of half that radius
// cannot enter from outside.
Nodes close_gaps(const Nodes& nodes, const Grid& grid, double reach);

// Separate runs of nodes in one column, and the most in any.
int bands(const Nodes& nodes, const Grid& grid, int column);
int max_bands(const Nodes& nodes, const Grid& grid);

// The farthest place on a crack along x, in m; 0 when there is none.
double tip_place(const Nodes& nodes, const Grid& grid);

}  // namespace hackle
