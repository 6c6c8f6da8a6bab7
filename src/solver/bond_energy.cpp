// SPDX-License-Identifier: MIT
#include "solver/bond_energy.hpp"

#include <cmath>

#include "solver/bond_visit.hpp"

namespace hackle {

BondEnergy bond_energy(const Lattice& lattice, const State& state,
                       const std::vector<double>& heat) {
  BondEnergy sums;
  visit_bonds(lattice, state, heat, [&](const VisitedBond& bond) {
    const double cost = bond.weight * bond.length * bond.c;
    if (bond.holds)
      sums.held += cost * bond.s * bond.s;
    else
      sums.broken += cost * bond.s0 * bond.s0;
  });
  // Half from the micropotential; V^2 |xi| is dx^5.
  const double unit = 0.5 * std::pow(lattice.grid.dx, 5);
  return {unit * sums.held, unit * sums.broken};
}

}  // namespace hackle
