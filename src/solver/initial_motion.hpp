// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/loads/initial_condition.hpp"
#include "solver/state.hpp"

namespace hackle {

// Gives a state at rest its initial conditions, added where their areas overlap: summed and rounded
// once to the precision of the state, in whatever order they were said.
void set_in_motion(const std::vector<InitialCondition>& conditions, const Lattice& lattice,
                   double dt, State& state);

}  // namespace hackle
