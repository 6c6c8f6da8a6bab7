// SPDX-License-Identifier: MIT
// The symbol of the linearised lattice: what it does to a plane wave. Gives the exact dispersion
// relation and with it the exact limit of the time step.
#pragma once

#include "lattice/family.hpp"

namespace hackle {

// Eigenvalues rho omega^2 of D(k) = sum_p w_p c V (xi xi^T/|xi|^3)(1 - cos k.xi), over the directed
// bonds (physics.md 5.1), in N/m4 for rho omega^2; `k` in rad per dx. least <= most.
struct Branches {
  double least = 0.0;
  double most = 0.0;
};
Branches symbol(const Family& family, double c, double dx, const Vec2& k);

// The largest angular frequency of the lattice, rad/s: the maximum of sqrt(most/rho) over all k,
// to a relative 1e-9. Free edges, cracks and broken bonds only take stiffness away, so it bounds
// every plate made of this lattice.
double largest_frequency(const Family& family, double c, double rho, double dx);

// Velocity Verlet is stable for steps up to 2/omega_max, in s.
double step_limit(const Family& family, double c, double rho, double dx);

}  // namespace hackle
