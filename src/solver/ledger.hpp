// SPDX-License-Identifier: MIT
#pragma once

namespace hackle {

// What was put into a plate and taken from it, besides the energy of motion and bonds
// (src/solver/README.md 3.4). In units of rho dx^4/dt^2, or J/m.
struct Ledger {
  double external = 0.0;  // done by loads, supports and heat so far
  double damped = 0.0;    // taken by damping so far
  double released = 0.0;  // given off by jumps and on the way to rest so far
  // Stored in contacts now, or lost there when bonds broke; less what they store since the plate
  // came to rest, which took no notice of them.
  double contact = 0.0;
};

inline Ledger operator*(double unit, const Ledger& ledger) {
  return {unit * ledger.external, unit * ledger.damped, unit * ledger.released,
          unit * ledger.contact};
}

}  // namespace hackle
