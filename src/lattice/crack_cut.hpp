// SPDX-License-Identifier: MIT
// Which bonds a crack cuts.
#pragma once

#include "lattice/bonds.hpp"
#include "lattice/family.hpp"
#include "lattice/grid.hpp"

namespace hackle {

// Clears in `bonds` every bond that has a point in common with the crack. The two ends do not
// belong to the crack: a bond that only touches one holds, a node that lies on the crack between
// them loses all its bonds. Distances below 1e-9 dx count as 0. Both ends of a bond, and mirror
// images, come to the same decision to the last bit.
void cut(const Crack& crack, const Grid& grid, const Family& family, BondBits& bonds);

}  // namespace hackle
