// SPDX-License-Identifier: MIT
// A plate as LAMMPS (`pair_style peri/pmb`) can have it, in units of dx, of the step and of the
// density.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lattice/grid.hpp"
#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle {

// In these units the nodes lie at multiples of 1/2, and LAMMPS makes the same decisions as Hackle
// without a tolerance: squared distances are exact, so a neighbour at exactly the horizon counts.
// LAMMPS sets changes of length below 2.2e-16 to 0, which has no effect here; in SI units it would
// hide stretches of 4e-13.
struct LammpsScene {
  Grid grid;
  std::vector<char> removed;  // per node: removed material
  double m = 0.0;             // horizon
  // Weights fall to 1/2 at the horizon, and nodes repel each other when they come nearer than 0.9
  // of their distance and 1.35; otherwise all weights are 1, and nothing touches.
  bool is_ramped = false;
  double c = 0.0;          // micromodulus c dx dt^2/rho, for a volume of 1 and a density of 1
  double s00 = 0.0;        // critical stretch
  double alpha = 0.0;      // of s0 = s00 - alpha smin
  std::vector<Vec2> pull;  // per node: acceleration by the loads, dt^2/dx; empty without loads
  std::vector<char>
      strong;  // per node: its bonds never break; empty if none is. LAMMPS knows
               // strength per node: bonds between their neighbours do not break either
  std::vector<std::pair<std::size_t, std::size_t>> cuts;  // near nodes that no bond joins
};

// Returns the plate at t = 0, with the step `dt`, s. `notes` are told what LAMMPS does in another
// way. Throws Error (refused), naming all that peri/pmb cannot have: several materials, heat,
// contact, rigid bodies, scatter, supports, amplitudes, functions, initial motion, damping,
// foundations, absorbing edges, other quadratures and micromoduli, corrected surfaces.
LammpsScene lammps_scene(const Plate& plate, const Numerics& numerics, double dt,
                         std::vector<std::string>& notes);

}  // namespace hackle
