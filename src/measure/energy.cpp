// SPDX-License-Identifier: MIT
#include "measure/energy.hpp"

#include <algorithm>

#include "measure/field.hpp"
#include "solver/bond_energy.hpp"

namespace hackle {
Energy energy(const Simulation& simulation) {
  const BondEnergy bonds =
      bond_energy(simulation.lattice(), simulation.state(), simulation.thermal_strain());
  Energy energy;
  energy.kinetic = simulation.kinetic_energy();
  energy.strain = bonds.held;
  energy.broken = bonds.broken;
  energy.damped = simulation.damped_energy();
  energy.released = simulation.released_energy();
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
