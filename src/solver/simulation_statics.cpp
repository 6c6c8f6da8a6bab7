// SPDX-License-Identifier: MIT
// How a simulation comes to rest.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "solver/heat_work.hpp"
#include "solver/quasistatic.hpp"
#include "solver/simulation.hpp"

namespace hackle {

namespace {

void check_tolerance(double tolerance, const char* who) {
  if (!(tolerance > 0.0 && tolerance < 1.0))
    throw Error(
        ErrorKind::refused,
        fmt::format("{}: the tolerance is {}, it must lie between 0 and 1", who, tolerance));
}

}  // namespace

void Simulation::check_statics(const RelaxOptions& options) const {
  check_tolerance(options.tolerance, options.who.c_str());
  if (!plate_.loads.impactors.empty())
    throw Error(ErrorKind::refused,
                fmt::format("{}: a plate that is being hit cannot be brought to rest", options.who),
                "bring it to rest before s:impactor{}, or let damping calm it");
}

void Simulation::put(const NodeVectors& u) {
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i) {
      const auto at = static_cast<std::size_t>(state_.layout.at(i, j));
      state_.set_u(i, j, {u.x[at], u.y[at]});
    }
}

// Loads that were added to a plate at rest grow from nothing; loads that have acted in steps have
// done their work and stay what they are.
Simulation::Departure Simulation::depart() {
  Departure from{borne_, heat_.values()};
  if (!state_.is_start()) {
    loading_.halt(state_, 0.0);
    from.loads = loading_.forces();
  }
  state_.external_work = external_work() / energy_unit();
  state_.damped = damped_energy() / energy_unit();
  state_.released += kinetic_energy() / energy_unit();
  return from;
}

// Half of the change of temperature acts where the plate was, half where it comes to rest: exact
// while forces are linear in both.
Equilibrium Simulation::go_to_rest(const Departure& from, StaticEquilibrium& equilibrium,
                                   const RelaxOptions& options) {
  const bool heats = from.heat != heat_.values();
  equilibrium.comes_from(from.loads, heats ? from.heat : std::span<const double>());
  const auto heating = [&] {
    return heats ? 0.5 * heat_work(lattice_, state_, from.heat, heat_.values(), threads_) : 0.0;
  };
  const double before = heating();
  Equilibrium rest = settle(equilibrium, options);
  state_.external_work += (before + heating()) / energy_unit();
  return rest;
}

// Moves the plate to where it comes to rest and books the work.
Equilibrium Simulation::settle(StaticEquilibrium& equilibrium, const RelaxOptions& options) {
  Equilibrium rest = equilibrium.solve(options);
  put(rest.u);
  const double unit = lattice_.calibration.c * std::pow(lattice_.grid.dx, 5) / energy_unit();
  state_.external_work += rest.work.external * unit;
  state_.released += rest.work.released * unit;
  return rest;
}

// Leaves the plate at rest under the loads that act since Loading::halt(). Contacts took no part:
// what is stored in them now and was not before came from nowhere.
void Simulation::come_to_rest(std::vector<BrokenBond> broken_bonds) {
  borne_ = loading_.forces();
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i) state_.set_v(i, j, {0, 0});
  state_.start = state_.step;
  if (state_.precision() == Precision::f32) keep_f32_exact();
  const double stored = loading_.contact_energy();
  prepare();
  state_.contact_lost -= loading_.contact_energy() - stored;
  std::visit([&](auto& engine) { engine.note_broken_bonds(std::move(broken_bonds)); }, engine_);
}

RelaxResult Simulation::relax(const RelaxOptions& options) {
  check_statics(options);
  const State before = state_;
  try {
    const Departure from = depart();
    loading_.halt(state_, 0.0);
    StaticEquilibrium equilibrium(lattice_, state_, loading_, heat_.values(), threads_);
    const RelaxResult result = go_to_rest(from, equilibrium, options).result;
    come_to_rest({});
    return result;
  } catch (...) {
    state_ = before;
    throw;
  }
}

QuasistaticResult Simulation::load_slowly(const QuasistaticOptions& options,
                                          std::span<Observer* const> observers) {
  if (!(options.duration > 0.0) || !std::isfinite(options.duration) || options.increments < 1)
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: {} s in {} increments; there must be more than 0 s and at "
                    "least 1 increment",
                    options.duration, options.increments));
  const double begin = time(), end = end_time_ + options.duration;
  if (!(begin + options.duration <= max_steps * dt_))
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: the duration is {}, which is more than {:.0e} steps of {}",
                    quantity(options.duration, "s"), max_steps, quantity(dt_, "s")));
  if (!(begin + options.duration / options.increments > begin))
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: an increment of {} cannot be told apart at {}",
                    quantity(options.duration / options.increments, "s"), quantity(begin, "s")),
        "take a longer duration or fewer increments");
  QuasistaticResult result;
  break_off_ = false;
  let_look(observers);
  int k = 0;
  while (++k <= options.increments && result.bears && !break_off_) {
    load_to(begin + std::max(end - begin, 0.0) * k / options.increments, options, result);
    let_look(observers);
  }
  // What a step or a run went too far is not owed, here as there.
  if (k > options.increments && result.bears && !break_off_) end_time_ = end;
  return result;
}

// A failure after bonds have broken in this increment means that the plate has come apart: the rest
// of it has no equilibrium.
void Simulation::load_to(double end, const QuasistaticOptions& options, QuasistaticResult& result) {
  const State before = state_;
  const std::vector<LoadedNode> borne = borne_;
  const auto undo = [&] {
    restore(before);
    borne_ = borne;
  };
  std::vector<BrokenBond> broken_bonds;
  result.passes.push_back(0);
  try {
    break_and_settle(end, options, result, broken_bonds);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted || result.passes.back() <= 1) {
      undo();
      throw;
    }
    result.bears = false;
    result.why = error.what();
  } catch (...) {
    undo();
    throw;
  }
  come_to_rest(std::move(broken_bonds));
  stop();
}

// The first pass loads without breaking. All later ones are jumps: nothing is prescribed to move,
// and loads stay what they are.
void Simulation::break_and_settle(double end, const QuasistaticOptions& options,
                                  QuasistaticResult& result,
                                  std::vector<BrokenBond>& broken_bonds) {
  const int increment = static_cast<int>(result.passes.size()) - 1;
  const RelaxOptions each{options.tolerance,
                          [&](double fraction, int) {
                            if (!options.progress) return;
                            const bool loads = result.passes.back() == 1;
                            options.progress(
                                (increment + (loads ? fraction : 1.0)) / options.increments,
                                increment + 1, result.passes.back(), result.broken);
                          },
                          "quasistatic", "as it was before this increment"};
  check_statics(each);
  const Departure from = depart();
  const double passed = end - time();
  state_.clock = {end, state_.step};
  state_.start = state_.step;
  heat_.update(lattice_, state_);
  loading_.halt(state_, passed);
  StaticEquilibrium equilibrium(lattice_, state_, loading_, heat_.values(), threads_);
  ++result.passes.back();
  Equilibrium rest = go_to_rest(from, equilibrium, each);
  for (;;) {
    result.iterations += rest.result.iterations;
    const Breakage broken = break_worst(rest.beyond, state_.bonds);
    if (broken.broken_bonds.empty()) return;
    const double unit = lattice_.calibration.c * std::pow(lattice_.grid.dx, 5) / energy_unit();
    state_.released += broken.excess * unit;
    result.broken += std::ssize(broken.broken_bonds);
    broken_bonds.insert(broken_bonds.end(), broken.broken_bonds.begin(), broken.broken_bonds.end());
    ++result.passes.back();
    equilibrium.lose(broken.broken_bonds);
    rest = settle(equilibrium, each);
  }
}

}  // namespace hackle
