// SPDX-License-Identifier: MIT
#include "store/lattice_hash.hpp"

#include "base/hash.hpp"

namespace hackle {

std::string lattice_hash(const Lattice& lattice) {
  Hash hash;
  hash.add(std::span(&lattice.grid.nx, 1));
  hash.add(std::span(&lattice.grid.ny, 1));
  hash.add(std::span(&lattice.grid.dx, 1));
  hash.add(std::span(lattice.grid.centre.data(), 2));
  for (const MaterialOnLattice& known : lattice.materials)
    for (const double* constant : {&known.calibration.c, &known.calibration.s0})
      hash.add(std::span(constant, 1));
  hash.add(std::span(lattice.material));
  hash.add(std::span(lattice.bonds.words()));
  hash.add(std::span(lattice.initial_neighbours));
  hash.add(std::span(lattice.strength));
  hash.add(std::span(lattice.surface));
  return hash.hex();
}

}  // namespace hackle
