// SPDX-License-Identifier: MIT
#include "solver/bond_energy.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

// s from the relative displacement h of a bond xi, in units of dx, without cancellation.
double stretch(const Vec2& xi, const Vec2& h) {
  const double e = h.dot(h + 2.0 * xi) / xi.squaredNorm();
  return e / (1.0 + std::sqrt(std::max(1.0 + e, 0.0)));
}

// Sums w |xi| s^2 over the bonds that hold, and w |xi| over those that broke since t = 0.
struct BondSums {
  double held = 0.0;
  double broken = 0.0;
};

BondSums sum_bonds(const Lattice& lattice, const State& state) {
  BondSums sums;
  lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    const double cost = weight * xi.norm();
    for (int j = 0; j < lattice.grid.ny; ++j)
      for (int i = 0; i < lattice.grid.nx; ++i) {
        const std::ptrdiff_t at = state.layout.at(i, j);
        if (!lattice.bonds.holds(at, bit)) continue;
        if (!state.bonds.holds(at, bit)) {
          sums.broken += cost;
          continue;
        }
        const double s = stretch(xi, state.u(i + a, j + b) - state.u(i, j));
        sums.held += cost * s * s;
      }
  });
  return sums;
}

}  // namespace

BondEnergy bond_energy(const Lattice& lattice, const State& state) {
  const BondSums sums = sum_bonds(lattice, state);
  // Half from the micropotential; V^2 |xi| is dx^5.
  const double unit = 0.5 * lattice.calibration.c * std::pow(lattice.grid.dx, 5);
  const double s0 = lattice.calibration.s0;
  return {unit * sums.held, unit * s0 * s0 * sums.broken};
}

}  // namespace hackle
