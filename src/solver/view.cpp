// SPDX-License-Identifier: MIT
#include "solver/view.hpp"

#include "solver/moving_plate.hpp"

namespace hackle {

View::View(const MovingPlate& moving, double until)
    : View(moving.plate(), moving.numerics(), moving.lattice(), moving.dt(), moving.state(),
           moving.thermal_strain()) {
  moving_ = &moving;
  until_ = until;
}

double View::energy_unit() const {
  const double dx = lattice_->grid.dx;
  return lattice_->rho * dx * dx * (dx / dt_) * (dx / dt_);
}

Ledger View::ledger() const {
  if (moving_ != nullptr) return moving_->ledger();
  return energy_unit() *
         Ledger{state_->external_work, state_->damped, state_->released, state_->contact_lost};
}

double View::kinetic_energy() const {
  const std::vector<Vec2> now = velocities();
  double sum = 0.0;
  for (int j = 0; j < lattice_->grid.ny; ++j)
    for (int i = 0; i < lattice_->grid.nx; ++i)
      if (!lattice_->is_void(i, j))
        sum += lattice_->material_at(i, j).material.rho *
               now[lattice_->grid.index(i, j)].squaredNorm();
  return 0.5 * lattice_->grid.dx * lattice_->grid.dx * sum;
}

Vec2 View::displacement(int i, int j) const {
  return lattice_->grid.dx * (state_->origin + state_->u(i, j));
}

std::vector<Vec2> View::velocities() const {
  if (moving_ != nullptr) return moving_->velocities();
  const Grid& grid = lattice_->grid;
  std::vector<Vec2> result(grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) result[grid.index(i, j)] = grid.dx / dt_ * state_->v(i, j);
  return result;
}

Vec2 View::velocity(int i, int j) const {
  if (moving_ != nullptr) return moving_->velocity(i, j);
  return lattice_->grid.dx / dt_ * state_->v(i, j);
}

bool View::holds(int i, int j, int column, int row) const {
  return hackle::holds(lattice_->grid, lattice_->family, state_->bonds, i, j, column, row);
}

}  // namespace hackle
