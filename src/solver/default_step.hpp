// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "lattice/lattice.hpp"

namespace hackle {

// Returns the default step for a limit, s: `safety` times it, or up to a twentieth less, so that it
// divides a power of ten: 0.2 us where 0.209 us would do.
double default_step(double limit, double safety = step_fraction);
// Returns the default step, also short enough for every rigid body (see longest_step_of_bodies).
double default_step(const Plate& plate, const Lattice& lattice, double safety);

// Checks the step for loads that come later and limit it, of which `who` is one: "foundation";
// those of the plate are checked with the numerics. The limit holds for nodes deep in the plate;
// for those at a rim, which lack half their bonds, the reserve of the default step is enough (dense
// eigenvalues, m = 3 to 6). Throws Error (refused).
void check_step(const Plate& plate, const Lattice& lattice, double dt, std::string_view who);

}  // namespace hackle
