// SPDX-License-Identifier: MIT
// Finds the bonds that a crack cuts.
#pragma once

#include "lattice/bonds.hpp"
#include "lattice/family.hpp"
#include "lattice/grid.hpp"

namespace hackle {

// Clears in `bonds` every bond that shares a point with the crack. Its two ends belong to it only
// if they coincide or with CrackEnds::cut: else a bond that only touches an end stays, while a node
// on the crack between its ends loses all its bonds. Distances below 1e-9 dx count as 0. Both ends
// of a bond, and mirror images, give the same decision to the last bit.
void cut(const Crack& crack, const Grid& grid, const Family& family, BondBits& bonds);

}  // namespace hackle
