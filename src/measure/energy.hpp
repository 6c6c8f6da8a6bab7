// SPDX-License-Identifier: MIT
// The energy ledger of a simulation: W_external = E_kinetic + E_strain + E_broken + E_damped +
// E_released + E_contact + residual.
#pragma once

#include "solver/view.hpp"

namespace hackle {

// All in J per metre of thickness.
struct Energy {
  double kinetic = 0.0;  // sum of 1/2 rho V v^2
  double strain = 0.0;   // sum over the bonds that hold of 1/2 c w s^2 |xi| V^2, s without the
                         // thermal part
  double broken = 0.0;   // the same at s = s0, over the bonds that broke since t = 0: what the
                        // fracture energy G0 charges for them. Cuts made by the scene cost nothing.
  double damped = 0.0;    // kinetic energy taken by damping
  double released = 0.0;  // given off where a plate jumps from one state at rest to another, or is
                          // brought to rest: what would have become motion, and was taken away
  double contact = 0.0;   // stored where faces and fragments touch, or lost there when bonds broke;
                          // less what is stored since the plate came to rest without them
  double external = 0.0;  // work done by loads, supports and impactors, what the start gave, and by
                          // how much changes of temperature raised the strain energy
  double residual() const {
    return external - kinetic - strain - broken - damped - released - contact;
  }
};

Energy energy(const View& view);

struct DamageCount {
  std::int64_t broken_bonds = 0;  // since t = 0, each bond counted once
  double most = 0.0;              // largest damage of a node, 0..1
};

DamageCount count_damage(const View& view);

}  // namespace hackle
