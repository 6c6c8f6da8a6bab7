// SPDX-License-Identifier: MIT
#include "measure/energy.hpp"

#include <algorithm>
#include <cmath>

#include "measure/field.hpp"

namespace hackle {
namespace {

double kinetic_energy(const Simulation& simulation) {
  double sum = 0.0;
  for (const Vec2& v : simulation.velocities()) sum += v.squaredNorm();
  const double dx = simulation.lattice().grid.dx;
  return 0.5 * simulation.lattice().rho * dx * dx * sum;
}

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

BondSums sum_bonds(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const State& state = simulation.state();
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

Energy energy(const Simulation& simulation) {
  const Calibration& calibration = simulation.lattice().calibration;
  const BondSums sums = sum_bonds(simulation);
  // Half from the micropotential; V^2 |xi| is dx^5.
  const double unit = 0.5 * calibration.c * std::pow(simulation.lattice().grid.dx, 5);
  Energy energy;
  energy.kinetic = kinetic_energy(simulation);
  energy.strain = unit * sums.held;
  energy.broken = unit * calibration.s0 * calibration.s0 * sums.broken;
  energy.external = simulation.external_work();
  return energy;
}

DamageCount count_damage(const Simulation& simulation) {
  DamageCount count;
  count.broken_bonds = simulation.lattice().bonds.count() - simulation.state().bonds.count();
  const Field field = damage(simulation);
  count.most = *std::ranges::max_element(field.values);
  return count;
}

}  // namespace hackle
