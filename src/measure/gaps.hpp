// SPDX-License-Identifier: MIT
// Where the plate is open.
#pragma once

#include <vector>

#include "solver/view.hpp"

namespace hackle {

// Returns, by Grid::index, the share of the bonds of a node that it lacks, 0..1, of those that it
// would have without any crack. It is the damage, except that bonds of absent cracks, to which
// damage is not relative, count as well. 0 where void.
std::vector<float> gaps(const View& view);

}  // namespace hackle
