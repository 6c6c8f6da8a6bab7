// SPDX-License-Identifier: MIT
// The symbol of the linearised lattice: what it does to a plane wave. Gives the exact dispersion
// relation and with it the exact limit of the time step.
#pragma once

#include "lattice/family.hpp"

namespace hackle {

// Eigenvalues rho omega^2, in N/m4, of D(k) = sum_p w_p c V (xi xi^T/|xi|^3)(1 - cos k.o) over the
// directed bonds, o the offset of the neighbour (src/lattice/README.md 4.1). `k` in rad per dx.
// least <= most.
struct Branches {
  double least = 0.0;
  double most = 0.0;
};
Branches symbol(const Family& family, double c, double dx, const Vec2& k);

// The largest angular frequency of the lattice, rad/s: the maximum of sqrt(most/rho) over all k, to
// a relative 1e-9. It bounds every plate whose bonds have a micromodulus of at most c each and
// whose nodes a density of at least rho each: the stiffness is a sum of positive semidefinite
// matrices, one per bond, so free edges, cracks, broken and softer bonds only lower its
// eigenvalues, and heavier nodes lower the frequencies (src/lattice/README.md 4.3).
double largest_frequency(const Family& family, double c, double rho, double dx);

// What contacts and impacts (touching.hpp) make of rho omega^2: `bonds` times what it is, and
// `nodes` times c dx/m more.
struct Touching {
  double bonds = 1.0;
  double nodes = 0.0;
};

// Velocity Verlet is stable for steps up to 2/omega_max, in s.
double step_limit(const Family& family, double c, double rho, double dx,
                  const Touching& touching = {});

}  // namespace hackle
