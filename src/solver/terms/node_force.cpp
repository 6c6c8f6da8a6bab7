// SPDX-License-Identifier: MIT
#include "solver/terms/node_force.hpp"

#include "solver/bond_visit.hpp"

namespace hackle {

Vec2 pull_of_bonds(const Lattice& lattice, const State& state, const std::vector<double>& heat,
                   double dt, int i, int j) {
  if (lattice.is_void(i, j)) return {0, 0};
  const double rho = lattice.material_at(i, j).material.rho;
  const std::size_t own = lattice.grid.index(i, j);
  Vec2 sum(0, 0);
  visit_bonds_of(i, j, lattice, state, heat, [&](const VisitedBond& bond) {
    const double K = bond.c * bond.weight * lattice.grid.dx * dt * dt / (rho * bond.length);
    const Vec2 pull = K * bond.s / (1.0 + bond.s) * (bond.xi + bond.h);
    sum += bond.one == own ? pull : Vec2(-pull);
  });
  return sum;
}

}  // namespace hackle
