// SPDX-License-Identifier: MIT
// The energy in bonds.
#pragma once

#include <vector>

#include "lattice/lattice.hpp"
#include "solver/state.hpp"

namespace hackle {

// J per metre of thickness.
struct BondEnergy {
  double held = 0.0;    // sum over the intact bonds of 1/2 c w s^2 |xi| V^2
  double broken = 0.0;  // the same at their critical stretch, over bonds broken since t = 0
};

// Computes the energy in bonds. `heat` is the thermal strain by Grid::index; empty means 0. It is
// not part of the stretch: (1 + s)^2 - 1 = e - th_i - th_j.
BondEnergy bond_energy(const Lattice& lattice, const State& state,
                       const std::vector<double>& heat = {});

}  // namespace hackle
