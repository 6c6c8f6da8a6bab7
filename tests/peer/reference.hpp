// SPDX-License-Identifier: MIT
// The rules of LAMMPS's `peri/pmb`, written as plainly as possible.
#pragma once

#include <vector>

#include "lattice/family.hpp"
#include "peer/lammps.hpp"

namespace hackle::test {

// Velocity Verlet on a PeerPlate. An overstretched bond still pulls in the step that finds it, and
// is broken from the next step on. A bond is overstretched above the smaller s0 of its ends, and s0
// of a node is s00 - alpha smin, with smin the smallest stretch of its bonds one step earlier.
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
  std::vector<char> holds_;  // node * bonds per node + bond
};

}  // namespace hackle::test
