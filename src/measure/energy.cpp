// SPDX-License-Identifier: MIT
#include "measure/energy.hpp"

#include <algorithm>

#include "measure/field.hpp"
#include "solver/bond_energy.hpp"

namespace hackle {

Energy energy(const View& seen) {
  const View view = seen.at_step();
  const BondEnergy bonds = bond_energy(view.lattice(), view.state(), view.thermal_strain());
  const Ledger ledger = view.ledger();
  return {.kinetic = view.kinetic_energy(),
          .strain = bonds.held,
          .broken = bonds.broken,
          .damped = ledger.damped,
          .released = ledger.released,
          .contact = ledger.contact,
          .external = ledger.external};
}

DamageCount count_damage(const View& view) {
  DamageCount count;
  count.broken_bonds = view.lattice().bonds.count() - view.state().bonds.count();
  const Field field = damage(view);
  count.max = *std::ranges::max_element(field.values);
  return count;
}

}  // namespace hackle
