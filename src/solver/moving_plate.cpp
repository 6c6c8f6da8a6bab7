// SPDX-License-Identifier: MIT
#include "solver/moving_plate.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "lattice/check_numerics.hpp"
#include "solver/bond_energy.hpp"
#include "solver/cpu/engine.hpp"
#include "solver/cpu/tiles.hpp"
#include "solver/default_step.hpp"
#include "solver/f32_range.hpp"
#include "solver/initial_motion.hpp"
#include "solver/terms/damping.hpp"
#include "solver/terms/heat.hpp"
#include "solver/terms/node_force.hpp"

namespace hackle {
namespace {

constexpr std::int64_t steps_between_moves = 64;  // of the origin, in f32

const Plate& checked(const Plate& plate, const Numerics& numerics, InstructionSet set) {
  Problems problems;
  check(plate, problems);
  check(plate, numerics, available_memory(), problems);
  if (numerics.fused && !can_fuse(set))
    problems.add(fmt::format("simulate: there is no fused arithmetic with {} instructions",
                             instruction_set_names[static_cast<std::size_t>(set)]),
                 "leave out fused");
  problems.throw_if_any();
  return plate;
}

Lattice with_strength(Lattice lattice, std::vector<float> strength) {
  Problems problems;
  if (!strength.empty() && strength.size() != lattice.grid.nodes())
    problems.add(fmt::format("simulate: strength has {} values, the lattice {} nodes",
                             strength.size(), lattice.grid.nodes()),
                 "give one for every node, or none");
  if (!std::ranges::all_of(strength, [](float s) { return s > 0.0F; }))
    problems.add("simulate: a strength is not above 0", "give a share of the critical stretch");
  problems.throw_if_any();
  if (!strength.empty()) lattice.strength = std::move(strength);
  return lattice;
}

// The components along which a node is prescribed are those of `prescribed`, the others free.
Vec2 led(const PrescribedNode& node, const Vec2& prescribed, const Vec2& free) {
  return {node.along_x ? prescribed.x() : free.x(), node.along_y ? prescribed.y() : free.y()};
}

double motion_of(const Lattice& lattice, const State& state) {
  double doubled = 0.0;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j))
        doubled +=
            lattice.material_at(i, j).material.rho / lattice.rho * state.v(i, j).squaredNorm();
  return 0.5 * doubled;
}

}  // namespace

// The energy of the initial condition is booked as external work, and so is that of faces which it
// presses.
MovingPlate::MovingPlate(Plate plate, const Numerics& numerics, const Execution& execution,
                         std::vector<float> strength)
    : plate_(std::move(plate)),
      numerics_(numerics),
      lattice_(
          with_strength(Lattice(checked(plate_, numerics_, execution.instruction_set), numerics_),
                        std::move(strength))),
      state_(lattice_, numerics_.precision),
      dt_(numerics_.step.value_or(default_step(plate_, lattice_, numerics_.safety))),
      terms_(plate_, lattice_, dt_),
      ranks_(execution.ranks),
      instruction_set_(execution.instruction_set),
      threads_(execution.thread_count()),
      stepper_(make_stepper(numerics_.precision)) {
  set_in_motion(plate_.initial_conditions, lattice_, dt_, state_);
  throw_if_interrupted();
  prepare();
  const bool starts = !plate_.initial_conditions.empty() || terms_.find<Heat>() != nullptr;
  state_.external_work = starts ? energy() : terms_.stored();
}

Cloned<Stepper> MovingPlate::make_stepper(Precision precision) const {
  const EngineOptions options{
      .dt = dt_,
      .heated = terms_.find<Heat>() != nullptr,
      .fidelity = numerics_.fidelity,
      .breaking = numerics_.breaking,
      .set = instruction_set_,
      .arithmetic = numerics_.fused ? Arithmetic::fused : Arithmetic::plain,
      .slab = share_out_slabs(ranks_, tile_rows(lattice_.grid.ny, lattice_.family.reach()))};
  return make_engine(precision, lattice_, options, threads_);
}

void MovingPlate::prepare() {
  terms_.begin(around(), state_);
  terms_.update(around(), state_);
  stepper_->set_actions(terms_.actions());
  if (!thermal_strain().empty()) stepper_->set_heat(lattice_, thermal_strain());
  stepper_->prepare(lattice_, state_);
}

void MovingPlate::step() {
  const bool by_rows = terms_.keep_to_rows();
  const Surroundings here = around(terms_, by_rows ? slab() : undivided);
  const double kick = terms_.before_step(here, state_);
  stepper_->step(lattice_, state_, kick);
  complete_ = slab().is_whole();
  if (!by_rows) complete();
  ++state_.step;
  const bool vary = terms_.vary();
  terms_.add_work(here, state_, vary ? WorkOf::first_half : WorkOf::whole_step);
  terms_.follow(here, state_);
  if (terms_.update(here, state_)) stepper_->set_actions(terms_.actions());
  if (vary) terms_.add_work(here, state_, WorkOf::second_half);
  if (state_.precision() == Precision::f32 && state_.step % steps_between_moves == 0)
    keep_f32_exact();
}

void MovingPlate::complete() {
  if (!std::exchange(complete_, true)) stepper_->complete(state_);
}

// At fixed steps, so that the bits do not depend on the division of a run.
void MovingPlate::keep_f32_exact() {
  const Spread spread = spread_of(state_, lattice_.material, slab());
  if (!is_to_be_moved(spread, lattice_.min_stretch())) return;
  complete();
  const bool moved = take_out_drift(state_, lattice_.material);
  if (is_too_wide_for_f32(state_, lattice_.min_stretch(), lattice_.material)) {
    state_ = state_.in_f64();
    widened_at_ = time();
    stepper_ = make_stepper(Precision::f64);
    prepare();
  } else if (moved) {
    prepare();
  }
}

void MovingPlate::restore(State state) {
  if (state.precision() != state_.precision()) stepper_ = make_stepper(state.precision());
  state_ = std::move(state);
  borne_.clear();
  prepare();
}

void MovingPlate::resume(Plate plate, State state, std::optional<double> widened_at) {
  Problems problems;
  check(plate, problems);
  problems.throw_if_any();
  plate_ = std::move(plate);
  terms_ = Terms(plate_, lattice_, dt_);
  lattice_.step_limit = step_limit(lattice_, plate_);
  stepper_ = make_stepper(state.precision());
  widened_at_ = widened_at;
  restore(std::move(state));
}

void MovingPlate::close_ledger() {
  const Ledger open = ledger();
  state_.external_work = open.external / energy_unit();
  state_.damped = open.damped / energy_unit();
}

void MovingPlate::note_broken_bonds(std::vector<BrokenBond> broken_bonds) {
  stepper_->note_broken_bonds(std::move(broken_bonds));
}

void MovingPlate::come_to_rest(std::vector<BrokenBond> broken_bonds) {
  borne_ = terms_.actions().forces;
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i) state_.set_v(i, j, {0, 0});
  state_.start = state_.step;
  if (state_.precision() == Precision::f32) keep_f32_exact();
  const double stored = terms_.stored();
  prepare();
  state_.contact_lost -= terms_.stored() - stored;
  stepper_->note_broken_bonds(std::move(broken_bonds));
}

double MovingPlate::energy() const {
  const BondEnergy bonds = bond_energy(lattice_, state_, thermal_strain());
  return motion_of(lattice_, state_) + bonds.held / energy_unit() + terms_.stored();
}

// v is half a step old, except at the start; prescribed components need no correction.
// The half kick that v is behind u, for the acceleration of a step, both in lattice units.
Vec2 MovingPlate::caught_up(const Vec2& v, const Vec2& acceleration) const {
  if (state_.is_start()) return grid_speed() * v;
  const Damping half(0.5 * plate_.loads.damping * dt_);
  return grid_speed() * (half.keep * v + 0.5 * half.yield * acceleration);
}

std::vector<Vec2> MovingPlate::velocities() const {
  const Grid& grid = lattice_.grid;
  std::vector<Vec2> result = state_.is_start() ? std::vector<Vec2>(grid.nodes(), Vec2(0, 0))
                                               : stepper_->accelerations(lattice_, state_);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      Vec2& v = result[grid.index(i, j)];
      v = caught_up(state_.v(i, j), v);
    }
  for (const PrescribedNode& node : terms_.actions().prescribed) {
    Vec2& v = result[grid.index(node.i, node.j)];
    v = led(node, grid_speed() * state_.v(node.i, node.j), v);
  }
  return result;
}

Vec2 MovingPlate::velocity(int i, int j) const {
  const Vec2 free = caught_up(state_.v(i, j), acceleration(i, j));
  const auto* node = entry_of<PrescribedNode>(terms_.actions().prescribed, i, j, lattice_.grid);
  return node == nullptr ? free : led(*node, grid_speed() * state_.v(i, j), free);
}

// Of one node, in lattice units: by its bonds and by what else acts.
Vec2 MovingPlate::acceleration(int i, int j) const {
  Vec2 sum = pull_of_bonds(lattice_, state_, thermal_strain(), dt_, i, j);
  const auto* load = entry_of<LoadedNode>(terms_.actions().forces, i, j, lattice_.grid);
  if (load != nullptr) sum += dt_ * dt_ / lattice_.grid.dx * load->acceleration;
  return sum;
}

std::size_t MovingPlate::bytes() const {
  return state_.bytes() + stepper_->bytes() + lattice_.bytes() + terms_.bytes();
}

}  // namespace hackle
