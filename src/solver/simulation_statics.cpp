// SPDX-License-Identifier: MIT
// How a simulation comes to rest.
#include "base/error.hpp"
#include "solver/bond_energy.hpp"
#include "solver/relaxation.hpp"
#include "solver/simulation.hpp"

namespace hackle {

void Simulation::check_statics() const {
  if (!plate_.loads.heatings.empty())
    throw Error(ErrorKind::refused, "relax: a plate that is heated cannot be brought to rest",
                "leave out the heat, or let damping calm the plate");
}

Equilibrium Simulation::find_rest(const RelaxOptions& options) {
  check_statics();
  loading_.halt(state_);
  return Relaxation(lattice_, state_, loading_, threads_).solve(options);
}

// Loaded slowly, all work is in the bonds, has broken some, or went before.
void Simulation::rest_at(const NodeVectors& u) {
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i) {
      const auto at = static_cast<std::size_t>(state_.layout.at(i, j));
      state_.set_u(i, j, {u.x[at], u.y[at]});
      state_.set_v(i, j, {0, 0});
    }
  state_.start = state_.step;
  const BondEnergy bonds = bond_energy(lattice_, state_);
  state_.external_work = (bonds.held + bonds.broken) / energy_unit() + state_.damped;
  if (state_.precision() == Precision::f32) keep_f32_exact();
  prepare();
}

RelaxResult Simulation::relax(const RelaxOptions& options) {
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0))
    throw Error(ErrorKind::refused, "relax: the tolerance must lie between 0 and 1");
  const Equilibrium rest = find_rest(options);
  rest_at(rest.u);
  return rest.result;
}

}  // namespace hackle
