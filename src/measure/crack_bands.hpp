// SPDX-License-Identifier: MIT
// The nodes on cracks, and the bands they form where they are closer than the reach of a bond: a
// crack leaves a band as wide as a horizon, frayed and unevenly damaged.
#pragma once

#include <cstddef>
#include <vector>

#include "lattice/grid.hpp"
#include "measure/field.hpp"

namespace hackle {

// The damage above which a node lies on a crack: 0.4 to 0.5 on the sides of a straight crack.
inline constexpr float on_crack = 0.35F;

// Flags of nodes, by Grid::index.
using Nodes = std::vector<char>;

Nodes nodes_on_crack(const Field& damage);

// Fills gaps of up to about `reach` spacings: adds the nodes that a disc of half that radius cannot
// enter from outside.
Nodes close_gaps(const Nodes& nodes, const Grid& grid, double reach);

// Counts separate runs of nodes in one column, or the largest count of any column.
int bands(const Nodes& nodes, const Grid& grid, int column);
int max_bands(const Nodes& nodes, const Grid& grid);

// Returns the largest x of a node on a crack, in m; 0 if there is none.
double tip_place(const Nodes& nodes, const Grid& grid);

}  // namespace hackle
