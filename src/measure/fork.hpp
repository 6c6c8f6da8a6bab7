// SPDX-License-Identifier: MIT
// Where cracks fork, whichever way they run.
#pragma once

#include <vector>

#include "lattice/grid.hpp"
#include "measure/crack_bands.hpp"

namespace hackle {

// The places, m, from left to right, where cracks fork: where the middle lines of two branches
// meet. Branches count when each goes on for more than a horizon from where they lie a horizon
// apart, and they do not meet again. `nodes` lie on a crack, `at_start` did so before anything
// broke: branches lead away from the latter, or, in a crack that began elsewhere, from one of its
// ends. Cracks that cross or touch each other at the start do not fork there. `m` is the horizon in
// spacings.
std::vector<Vec2> forks(const Nodes& nodes, const Nodes& at_start, const Grid& grid, double m);

}  // namespace hackle
