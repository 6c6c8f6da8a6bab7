// SPDX-License-Identifier: MIT
// LAMMPS (`pair_style peri/pmb`) as a peer: the same plate, solved by an independent program.
#pragma once

#include <filesystem>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle::test {

// A plate in units of dx, of the step and of the density. In these units the nodes lie at multiples
// of 1/2, and LAMMPS makes the same decisions as Hackle without a tolerance: squared distances are
// exact, so a neighbour at exactly m dx counts (it tests r^2 <= m^2), and its weight 1 - (r - (m -
// 1/2)) is 1/2 as in Hackle's ramp. LAMMPS sets changes of length below 2.2e-16 to 0, which has no
// effect here; in SI units it would hide stretches of 4e-13.
struct PeerPlate {
  Grid grid;
  std::vector<char> removed;  // per node: removed material
  double m = 0.0;             // horizon
  double c = 0.0;             // micromodulus c dx dt^2/rho, for a volume of 1 and a density of 1
  double s00 = 0.0;           // critical stretch
  double alpha = 0.0;         // of s0 = s00 - alpha smin
  double pull = 0.0;  // acceleration of the top row along y, and minus that of the bottom row
};

// The state of the plate after a step.
struct PeerSample {
  int step = 0;
  std::vector<Vec2> u;         // displacement per node, in dx; 0 without a node
  std::vector<double> damage;  // per node: broken bonds over initial bonds
};

bool lammps_is_installed();

// Solves `steps` steps in `folder` and samples every `every` steps, including the start. Throws
// std::runtime_error with the last words of LAMMPS if it fails.
std::vector<PeerSample> run_lammps(const PeerPlate& plate, int steps, int every,
                                   const std::filesystem::path& folder);

}  // namespace hackle::test
