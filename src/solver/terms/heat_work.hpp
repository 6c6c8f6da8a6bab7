// SPDX-License-Identifier: MIT
// The work of a change of temperature.
#pragma once

#include <vector>

#include "lattice/lattice.hpp"
#include "solver/slab.hpp"
#include "solver/state.hpp"
#include "solver/threads.hpp"

namespace hackle {

// Computes the increase of the energy in bonds when the thermal strain of the nodes changes while
// they stay in place, J per metre of thickness. `before` and `after` are by Grid::index; empty
// means 0. The bits are the same for any number of threads.
double heat_work(const Lattice& lattice, const State& state, const std::vector<double>& before,
                 const std::vector<double>& after, const Threads& threads, const Slab& slab = {});

}  // namespace hackle
