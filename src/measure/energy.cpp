// SPDX-License-Identifier: MIT
#include "measure/energy.hpp"

#include <algorithm>

#include "measure/field.hpp"
#include "solver/bond_energy.hpp"

namespace hackle {
namespace {

double kinetic_energy(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const std::vector<Vec2> velocities = simulation.velocities();
  double sum = 0.0;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j))
        sum += lattice.material_at(i, j).material.rho *
               velocities[lattice.grid.index(i, j)].squaredNorm();
  return 0.5 * lattice.grid.dx * lattice.grid.dx * sum;
}

}  // namespace

Energy energy(const Simulation& simulation) {
  const BondEnergy bonds =
      bond_energy(simulation.lattice(), simulation.state(), simulation.thermal_strain());
  Energy energy;
  energy.kinetic = kinetic_energy(simulation);
  energy.strain = bonds.held;
  energy.broken = bonds.broken;
  energy.damped = simulation.damped_energy();
  energy.contact = simulation.contact_energy();
  energy.external = simulation.external_work();
  return energy;
}

DamageCount count_damage(const Simulation& simulation) {
  DamageCount count;
  count.broken_bonds = simulation.lattice().bonds.count() - simulation.state().bonds.count();
  const Field field = damage(simulation);
  count.most = *std::ranges::max_element(field.values);
  return count;
}

}  // namespace hackle
