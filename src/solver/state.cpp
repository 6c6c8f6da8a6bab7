// SPDX-License-Identifier: MIT
#include "solver/state.hpp"

#include "base/hash.hpp"

namespace hackle {

State::State(const Lattice& lattice)
    : layout{lattice.grid.nx, lattice.grid.ny, lattice.family.reach()},
      ux(layout.size()),
      uy(layout.size()),
      vx(lattice.grid.nodes()),
      vy(lattice.grid.nodes()),
      ax(lattice.grid.nodes()),
      ay(lattice.grid.nodes()),
      bonds(lattice.bonds) {
}

std::string State::hash() const {
  Hash hash;
  for (const auto* values : {&ux, &uy, &vx, &vy, &ax, &ay}) hash.add(std::span(*values));
  hash.add(std::span(bonds.planes()));
  hash.add(std::span(&step, 1));
  hash.add(std::span(&external_work, 1));
  return hash.hex();
}

}  // namespace hackle
