// SPDX-License-Identifier: MIT
// Where cracks fork, whichever way they run.
#pragma once

#include <vector>

#include "lattice/grid.hpp"
#include "measure/crack_bands.hpp"

namespace hackle {

// Where a band of a crack splits into branches that are each longer than a horizon from where
// they lie a horizon apart, and do not meet again: the places, m, where the middle lines of two
// branches meet, from left to right. `nodes` lie on a crack, `at_start` did so before anything
// broke: branches lead away from there, or, in a crack that has begun elsewhere, from one of its
// ends. `m` is the horizon in spacings. Cracks that cross or touch each other at the start do not
// fork there.
std::vector<Vec2> forks(const Nodes& nodes, const Nodes& at_start, const Grid& grid, double m);

}  // namespace hackle
