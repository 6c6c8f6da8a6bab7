// SPDX-License-Identifier: MIT
#include "measure/energy.hpp"

#include <algorithm>
#include <cmath>

#include "measure/field.hpp"

namespace hackle {
namespace {

double kinetic_energy(const Simulation& simulation) {
  const State& state = simulation.state();
  double sum = 0.0;
  for (std::size_t node = 0; node < state.vx.size(); ++node)
    sum += state.vx[node] * state.vx[node] + state.vy[node] * state.vy[node];
  const double dx = simulation.lattice().grid.dx;
  const double speed = dx / simulation.dt();
  return 0.5 * simulation.lattice().rho * dx * dx * speed * speed * sum;
}

// s from the relative displacement h of a bond (a, b), in units of dx, without cancellation.
double stretch(double a, double b, double hx, double hy) {
  const double e = (hx * (hx + 2.0 * a) + hy * (hy + 2.0 * b)) / (a * a + b * b);
  return e / (1.0 + std::sqrt(std::max(1.0 + e, 0.0)));
}

// Sums w |xi| s^2 over the directed bonds that hold, and w |xi| over those that broke since t = 0.
struct BondSums {
  double held = 0.0;
  double broken = 0.0;
};

BondSums sum_bonds(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const State& state = simulation.state();
  BondSums sums;
  for (const Images& image : lattice.family.images())
    for (int k = 0; k < image.count(); ++k) {
      const int a = image.column(k), b = image.row(k), bit = image.first_bit + k;
      const std::ptrdiff_t to = b * state.layout.stride() + a;
      const double cost = image.weight * image.length();
      for (int j = 0; j < lattice.grid.ny; ++j)
        for (int i = 0; i < lattice.grid.nx; ++i) {
          const std::size_t node = lattice.grid.index(i, j);
          if (!lattice.bonds.holds(node, bit)) continue;
          if (!state.bonds.holds(node, bit)) {
            sums.broken += cost;
            continue;
          }
          const auto here = static_cast<std::size_t>(state.layout.at(i, j));
          const auto there = static_cast<std::size_t>(state.layout.at(i, j) + to);
          const double s =
              stretch(a, b, state.ux[there] - state.ux[here], state.uy[there] - state.uy[here]);
          sums.held += cost * s * s;
        }
    }
  return sums;
}

}  // namespace

Energy energy(const Simulation& simulation) {
  const Calibration& calibration = simulation.lattice().calibration;
  const BondSums sums = sum_bonds(simulation);
  // Half for the two directions of a bond, half from the micropotential; V^2 |xi| is dx^5.
  const double unit = 0.25 * calibration.c * std::pow(simulation.lattice().grid.dx, 5);
  Energy energy;
  energy.kinetic = kinetic_energy(simulation);
  energy.strain = unit * sums.held;
  energy.broken = unit * calibration.s0 * calibration.s0 * sums.broken;
  energy.external = simulation.external_work();
  return energy;
}

DamageCount count_damage(const Simulation& simulation) {
  DamageCount count;
  count.broken_bonds = (simulation.lattice().bonds.count() - simulation.state().bonds.count()) / 2;
  const Field field = damage(simulation);
  count.most = *std::ranges::max_element(field.values);
  return count;
}

}  // namespace hackle
