// SPDX-License-Identifier: MIT
// The symbol of the linearised lattice: its action on a plane wave. It gives the exact dispersion
// relation, and thus the exact limit of the time step.
#pragma once

#include "lattice/family.hpp"

namespace hackle {

// Eigenvalues rho omega^2, in N/m4, of D(k) = sum_p w_p c V (xi xi^T/|xi|^3)(1 - cos k.o) over the
// directed bonds, o the offset of the neighbour (src/lattice/README.md 4.1). `k` in rad per dx.
// least <= most.
struct Branches {
  double min = 0.0;
  double max = 0.0;
};
Branches symbol(const Family& family, double c, double dx, const Vec2& k);

// Computes the largest angular frequency of the lattice, rad/s: the maximum of sqrt(most/rho) over
// all k, to a relative 1e-9. It bounds every plate whose bonds have a micromodulus of at most c and
// whose nodes a density of at least rho: the stiffness is a sum of positive semidefinite matrices,
// one per bond, so free edges, cracks, broken and softer bonds only lower its eigenvalues, and
// heavier nodes lower the frequencies (src/lattice/README.md 4.3).
double largest_frequency(const Family& family, double c, double rho, double dx);

// The effect of contacts, impacts and springs (touching.hpp) on rho omega^2: it is multiplied by
// `bonds`, then `nodes` times c dx/m and `springs` are added.
struct Touching {
  double bonds = 1.0;
  double nodes = 0.0;
  double springs = 0.0;  // N/m4
  // Of forces that resist velocities, which are those of half a step ago: the share of the limit
  // that drag leaves, and the beta of stiffness damping, s (src/lattice/README.md 4.7).
  double left_by_drag = 1.0;
  double stiffness_damping = 0.0;

  bool operator==(const Touching&) const = default;
};

// Returns the stability limit of velocity Verlet, 2/omega_max without drag, in s.
double step_limit(const Family& family, double c, double rho, double dx,
                  const Touching& touching = {});

}  // namespace hackle
