// SPDX-License-Identifier: MIT
// LAMMPS (`pair_style peri/pmb`) as a peer: the same plate, solved by an independent program.
#pragma once

#include <filesystem>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle::test {

// A plate in units of dx, of the step and of the density (see LammpsScene), which a test fills from
// the formulas.
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

// Runs plate.in in `folder`, which samples into nodes.dump. Throws std::runtime_error with the last
// words of LAMMPS if it fails.
std::vector<PeerSample> run_deck(const std::filesystem::path& folder, const Grid& grid);

// Solves `steps` steps in `folder` and samples every `every` steps, including the start. Throws
// std::runtime_error with the last words of LAMMPS if it fails.
std::vector<PeerSample> run_lammps(const PeerPlate& plate, int steps, int every,
                                   const std::filesystem::path& folder);

}  // namespace hackle::test
