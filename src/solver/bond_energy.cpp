// SPDX-License-Identifier: MIT
#include "solver/bond_energy.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

// s from the relative displacement h of a bond xi, in units of dx, without cancellation. `heat` is
// the thermal part of e.
double stretch(const Vec2& xi, const Vec2& h, double heat) {
  const double e = h.dot(h + 2.0 * xi) / xi.squaredNorm() - heat;
  return e / (1.0 + std::sqrt(std::max(1.0 + e, 0.0)));
}

// Sums c w |xi| s^2 over the bonds that hold, and c w |xi| s0^2 over those that broke since t = 0.
struct BondSums {
  double held = 0.0;
  double broken = 0.0;
};

// What differs from node to node, by Grid::index.
struct HeatedNodes {
  std::vector<double> c, s0, heat;
};

HeatedNodes heated_nodes(const Lattice& lattice, const std::vector<double>& heat) {
  HeatedNodes values{{}, {}, heat};
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i) {
      values.c.push_back(lattice.micromodulus_at(i, j));
      values.s0.push_back(lattice.critical_stretch_at(i, j));
    }
  values.heat.resize(lattice.grid.nodes());
  return values;
}

BondSums sum_bonds(const Lattice& lattice, const State& state, const HeatedNodes& values) {
  BondSums sums;
  lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    const double length = weight * xi.norm();
    for (int j = 0; j < lattice.grid.ny; ++j)
      for (int i = 0; i < lattice.grid.nx; ++i) {
        const std::ptrdiff_t at = state.layout.at(i, j);
        if (!lattice.bonds.holds(at, bit)) continue;
        const std::size_t one = lattice.grid.index(i, j), other = lattice.grid.index(i + a, j + b);
        const double cost = length * 0.5 * (values.c[one] + values.c[other]);
        if (!state.bonds.holds(at, bit)) {
          const double s0 = std::min(values.s0[one], values.s0[other]);
          sums.broken += cost * s0 * s0;
          continue;
        }
        const double s = stretch(xi, state.u(i + a, j + b) - state.u(i, j),
                                 values.heat[one] + values.heat[other]);
        sums.held += cost * s * s;
      }
  });
  return sums;
}

}  // namespace

BondEnergy bond_energy(const Lattice& lattice, const State& state,
                       const std::vector<double>& heat) {
  const BondSums sums = sum_bonds(lattice, state, heated_nodes(lattice, heat));
  // Half from the micropotential; V^2 |xi| is dx^5.
  const double unit = 0.5 * std::pow(lattice.grid.dx, 5);
  return {unit * sums.held, unit * sums.broken};
}

}  // namespace hackle
