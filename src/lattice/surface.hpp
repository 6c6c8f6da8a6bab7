// SPDX-License-Identifier: MIT
// The correction of the stiffness of nodes near a surface (src/lattice/README.md 3.9).
#pragma once

#include <vector>

#include "lattice/bonds.hpp"
#include "lattice/family.hpp"
#include "lattice/grid.hpp"

namespace hackle {

// No node is stiffened more: twice is what a straight edge of a continuous plate needs. The limit
// of the time step relies on it before there is a lattice.
inline constexpr double most_surface_factor = 2.0;

// Returns the largest factor that the correction may give a bond: 1, or most_surface_factor.
double stiffening(Surface surface);

// Returns the factor of the micromodulus of every node, by Grid::index, 1 to most_surface_factor;
// empty without a correction. It is exactly 1 for nodes with all bonds of the family, and the same
// for mirror images to the last bit. `bonds` are those that hold at t = 0, after all cuts.
std::vector<float> surface_factors(Surface surface, const Grid& grid, const Family& family,
                                   const BondBits& bonds);

}  // namespace hackle
