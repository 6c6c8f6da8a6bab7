// SPDX-License-Identifier: MIT
#include "solver/view.hpp"

#include <utility>

#include "solver/moving_plate.hpp"

namespace hackle {

View::View(const MovingPlate& moving, double until, std::optional<Instant> instant)
    : View(moving.plate(), moving.numerics(), moving.lattice(), moving.dt(), moving.state(),
           moving.thermal_strain()) {
  moving_ = &moving;
  until_ = until;
  instant_ = std::move(instant);
}

View View::at_step() const {
  View view = *this;
  view.instant_.reset();
  return view;
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
  const Vec2 moved = behind() == 0.0 ? Vec2(0.0, 0.0) : Vec2(behind() * state_->v(i, j));
  return lattice_->grid.dx * (state_->origin + state_->u(i, j) - moved);
}

Vec2 View::velocity_then(const Vec2& now, int i, int j) const {
  if (behind() == 0.0) return now;
  const Vec2 before = half_step_velocity(i, j);
  return before + (1.0 - 2.0 * behind()) * (now - before);
}

std::vector<Vec2> View::velocities() const {
  const Grid& grid = lattice_->grid;
  std::vector<Vec2> result =
      moving_ != nullptr ? moving_->velocities() : std::vector<Vec2>(grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      Vec2& v = result[grid.index(i, j)];
      v = moving_ != nullptr ? velocity_then(v, i, j) : half_step_velocity(i, j);
    }
  return result;
}

Vec2 View::velocity(int i, int j) const {
  if (moving_ == nullptr) return half_step_velocity(i, j);
  return velocity_then(moving_->velocity(i, j), i, j);
}

bool View::holds(int i, int j, int column, int row) const {
  return hackle::holds(lattice_->grid, lattice_->family, state_->bonds, i, j, column, row);
}

}  // namespace hackle
