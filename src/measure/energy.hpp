// SPDX-License-Identifier: MIT
// The energy ledger of a simulation: W_external = E_kinetic + E_strain + E_broken + E_damped +
// E_released + E_contact + residual.
#pragma once

#include "solver/view.hpp"

namespace hackle {

// All in J per metre of thickness.
struct Energy {
  double kinetic = 0.0;   // sum of 1/2 rho V v^2
  double strain = 0.0;    // sum over the intact bonds of 1/2 c w s^2 |xi| V^2, s without the
                          // thermal part
  double broken = 0.0;    // the same at s = s0, over the bonds broken since t = 0: the fracture
                          // energy G0 of these bonds. Cuts made by the scene cost nothing.
  double damped = 0.0;    // kinetic energy dissipated by damping
  double released = 0.0;  // set free when a plate jumps from one static equilibrium to another, or
                          // is brought into one: energy that would have become motion and was
                          // removed
  double contact = 0.0;   // stored where faces and fragments touch, or lost there when bonds broke;
                          // minus the part stored since the plate reached an equilibrium without
                          // contact
  double external = 0.0;  // work of loads, supports and impactors, energy of initial conditions,
                          // and the increase of strain energy by changes of temperature
  double residual() const {
    return external - kinetic - strain - broken - damped - released - contact;
  }
};

Energy energy(const View& view);

struct DamageCount {
  std::int64_t broken_bonds = 0;  // since t = 0, each bond counted once
  double max = 0.0;               // largest damage of a node, 0..1
};

DamageCount count_damage(const View& view);

}  // namespace hackle
