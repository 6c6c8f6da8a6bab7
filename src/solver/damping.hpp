// SPDX-License-Identifier: MIT
// Viscous damping: velocities die away.
#pragma once

#include "lattice/lattice.hpp"
#include "solver/state.hpp"
#include "solver/threads.hpp"

namespace hackle {

// Makes every velocity `keep` times what it was. Returns the kinetic energy that goes, in units of
// rho dx^4/dt^2 (J/m); its bits do not depend on the number of threads.
double damp(const Lattice& lattice, double keep, const Threads& threads, State& state);

}  // namespace hackle
