// SPDX-License-Identifier: MIT
// How a plate takes other loads between two steps (src/solver/README.md 3.4): the half of its work
// that a load does after a step is not the one that it would have done.
#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include "lattice/lattice.hpp"
#include "lattice/touching.hpp"
#include "solver/default_step.hpp"
#include "solver/moving_plate.hpp"
#include "solver/terms/damping.hpp"
#include "solver/terms/heat.hpp"

namespace hackle {
namespace {

// The name of what limits the step with the next loads and not, or less, with those of before; ""
// if there is none.
std::string_view limits_more(const Loads& next, const Loads& before) {
  if (next.impactors.size() > before.impactors.size()) return "impactor";
  if (next.rollers.size() > before.rollers.size()) return "roller";
  if (next.platens.size() > before.platens.size()) return "platen";
  if (spring_stiffness(next) > spring_stiffness(before)) return "foundation";
  if (next.absorbers.size() > before.absorbers.size()) return "absorb";
  return next.stiffness_damping > before.stiffness_damping ? "damping" : "";
}

}  // namespace

// The terms of a plate with other loads, ready to act on the state; what it says is checked. Throws
// with the plate as it was.
Terms MovingPlate::terms_for(const Plate& plate, std::int64_t last_step) {
  Problems problems;
  check(plate, problems);
  problems.throw_if_any();
  Terms next(plate, lattice_, dt_);
  const std::string_view who = limits_more(plate.loads, plate_.loads);
  if (!who.empty() && !numerics_.force_step) check_step(plate, lattice_, dt_, who);
  next.tabulate(state_.clock, state_.step, std::max(state_.step, last_step) + 1, dt_);
  const auto bodies = std::tie(state_.discs, state_.rollers, state_.platens);
  const std::tuple<std::vector<Disc>, std::vector<Disc>, std::vector<Disc>> before = bodies;
  try {
    next.begin(around(next, undivided), state_);
  } catch (...) {
    std::tie(state_.discs, state_.rollers, state_.platens) = before;
    throw;
  }
  next.go_on_from(terms_);
  return next;
}

void MovingPlate::set_loads(Loads loads, std::int64_t last_step) {
  Plate plate = plate_;
  plate.loads = std::move(loads);
  Terms next = terms_for(plate, last_step);
  state_.external_work += heat_work_of_change(next);
  const double work = work_of_half_step(), loss = lost_in_half_step();
  const double dragged = terms_.drag_of_half_step(around(), state_);
  const double damping = plate.loads.damping;
  const bool rebuild = next.thermal_strain().empty() != thermal_strain().empty();
  const double dx = lattice_.grid.dx;
  const bool limits = touching_of(plate, dx) != touching_of(plate_, dx);
  next.set_damping(plate_.loads.damping);
  plate.loads.damping = plate_.loads.damping;
  terms_ = std::move(next);
  plate_ = std::move(plate);
  if (limits) lattice_.step_limit = step_limit(lattice_, plate_);
  if (rebuild) stepper_ = make_stepper(state_.precision());
  prepare();
  state_.external_work += work_of_half_step() - work;
  state_.damped += loss - lost_in_half_step();  // other nodes are led
  const double more_drag = terms_.drag_of_half_step(around(), state_) - dragged;
  state_.external_work += more_drag;  // which is among all work
  state_.damped += more_drag;
  if (damping != plate_.loads.damping) change_damping(damping);
}

// Temperatures jump while the nodes stay where they are.
double MovingPlate::heat_work_of_change(const Terms& next) const {
  const Heat *was = terms_.find<Heat>(), *is = next.find<Heat>();
  if (was == nullptr && is == nullptr) return 0.0;
  const auto before = [this](const Heat* heat) {
    return heat == nullptr ? std::vector<double>() : heat->strain().before(lattice_, state_);
  };
  return work_of_heating(around(), state_, before(was), before(is));
}

// The work of all accelerations in the second half of the last step. What acts at a step does half
// its work in the step before, so changed loads or temperatures change that work.
double MovingPlate::work_of_half_step() const {
  if (state_.is_start()) return 0.0;
  const Grid& grid = lattice_.grid;
  const std::vector<Vec2> a = stepper_->accelerations(lattice_, state_);
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (!lattice_.is_void(i, j))
        sum += lattice_.material_at(i, j).material.rho / lattice_.rho *
               a[grid.index(i, j)].dot(state_.v(i, j));
  return 0.5 * sum;
}

double MovingPlate::lost_in_half_step() const {
  const auto* damping = terms_.find<ViscousDamping>();
  return damping == nullptr ? 0.0 : damping->lost_in_half_step(around(), state_);
}

// v becomes the present velocity, as at the start: the rate of the step that produced it does not
// hold for the next one.
void MovingPlate::change_damping(double rate) {
  const std::vector<Vec2> now = velocities();
  close_ledger();
  const double unit = dt_ / lattice_.grid.dx;
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i)
      state_.set_v(i, j, unit * now[lattice_.grid.index(i, j)]);
  state_.start = state_.step;
  plate_.loads.damping = rate;
  terms_.set_damping(rate);
  prepare();
}

}  // namespace hackle
