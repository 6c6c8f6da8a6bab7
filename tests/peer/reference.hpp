// SPDX-License-Identifier: MIT
// The rules of LAMMPS's `peri/pmb`, as plainly as they can be written.
#pragma once

#include <vector>

#include "lattice/family.hpp"
#include "peer/lammps.hpp"

namespace hackle::test {

// Velocity Verlet on a PeerPlate. A bond found over-stretched still pulls in that step and is gone
// from the next on. It is over-stretched above the lesser s0 of its ends, and s0 of a node is
// s00 - alpha smin, smin the least stretch of its bonds one step before.
class Reference {
 public:
  explicit Reference(const PeerPlate& plate);

  void step();
  bool holds(int i, int j, int column, int row) const;
  Vec2 displacement(int i, int j) const { return u_[plate_.grid.index(i, j)]; }  // in dx

 private:
  struct Bond {
    int column, row;
    double weight;
  };
  void forces();
  void pull_on(int i, int j);

  PeerPlate plate_;
  std::vector<Bond> family_;
  std::vector<Vec2> u_, v_, a_;
  std::vector<double> s0_, next_s0_;
  std::vector<char> holds_;  // node * bonds of a node + bond
};

}  // namespace hackle::test
