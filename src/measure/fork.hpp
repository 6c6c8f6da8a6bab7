// SPDX-License-Identifier: MIT
// Finds where cracks fork, in any direction.
#pragma once

#include <vector>

#include "lattice/grid.hpp"
#include "measure/crack_bands.hpp"

namespace hackle {

// Returns the points, m, from left to right, where cracks fork: where the middle lines of two
// branches meet. Branches count if each continues for more than a horizon beyond the point where
// they are a horizon apart, and they do not meet again. `nodes` lie on a crack, `at_start` did so
// before anything broke: branches lead away from the latter, or, in a crack that began elsewhere,
// from one of its ends. Initial cracks that cross or touch each other do not fork there. `m` is the
// horizon in spacings.
std::vector<Vec2> forks(const Nodes& nodes, const Nodes& at_start, const Grid& grid, double m);

}  // namespace hackle
