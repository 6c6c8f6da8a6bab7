// SPDX-License-Identifier: MIT
#include "store/lattice_hash.hpp"

#include <gtest/gtest.h>

#include "support/composite.hpp"

namespace hackle {
namespace {

// Changes everything on which the restored states depend, one at a time.
TEST(LatticeHash, KnowsEveryMember) {
  const Lattice lattice(test::composite(20, 16, {.mixed = true}), test::numerics());
  struct Change {
    const char* member;
    void (*make)(Lattice&);
  };
  const Change changes[] = {
      {"nx", [](Lattice& l) { ++l.grid.nx; }},
      {"ny", [](Lattice& l) { ++l.grid.ny; }},
      {"dx", [](Lattice& l) { l.grid.dx *= 2.0; }},
      {"centre, x", [](Lattice& l) { l.grid.centre.x() += 1e-3; }},
      {"centre, y", [](Lattice& l) { l.grid.centre.y() += 1e-3; }},
      {"c", [](Lattice& l) { l.materials.front().calibration.c *= 2.0; }},
      {"s0", [](Lattice& l) { l.materials.front().calibration.s0 *= 2.0; }},
      {"c of another", [](Lattice& l) { l.materials.back().calibration.c *= 2.0; }},
      {"s0 of another", [](Lattice& l) { l.materials.back().calibration.s0 *= 2.0; }},
      {"material", [](Lattice& l) { l.material.back() = 1; }},
      {"bonds", [](Lattice& l) { l.bonds.clear(l.grid.layout().at(2, 2), 3); }},
      {"initial_neighbours", [](Lattice& l) { ++l.initial_neighbours.back(); }},
      {"strength", [](Lattice& l) { l.strength.assign(l.grid.nodes(), 1.0F); }}};
  for (const Change& change : changes) {
    Lattice other = lattice;
    change.make(other);
    EXPECT_NE(lattice_hash(other), lattice_hash(lattice)) << change.member;
  }
  EXPECT_EQ(lattice_hash(Lattice(lattice)), lattice_hash(lattice));
}

}  // namespace
}  // namespace hackle
