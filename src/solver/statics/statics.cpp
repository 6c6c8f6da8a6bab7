// SPDX-License-Identifier: MIT
#include "solver/statics/statics.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "solver/statics/breakage.hpp"
#include "solver/terms/guided_bodies.hpp"
#include "solver/terms/heat_work.hpp"
#include "solver/view.hpp"

namespace hackle {
namespace {

void check_tolerance(double tolerance, const std::string& who) {
  if (!(tolerance > 0.0 && tolerance < 1.0))
    throw Error(
        ErrorKind::refused,
        fmt::format("{}: the tolerance is {}, it must lie between 0 and 1", who, tolerance));
}

void put(const NodeVectors& u, State& state) {
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(state.layout.at(i, j));
      state.set_u(i, j, {u.x[at], u.y[at]});
    }
}

}  // namespace

double Statics::unit_of_work() const {
  return plate_.lattice().calibration.c * std::pow(plate_.lattice().grid.dx, 5) /
         plate_.energy_unit();
}

void Statics::check(const RelaxOptions& options) const {
  check_tolerance(options.tolerance, options.who);
  plate_.terms().check_rest(options.who);
}

// Loads that were added to a plate at rest grow from zero; loads that have acted in steps have done
// their work and stay unchanged.
Statics::Departure Statics::depart(const RelaxOptions& options) {
  Departure from{plate_.borne(), plate_.thermal_strain(), {}};
  if (const auto* bodies = plate_.terms().find<GuidedBodies>()) {
    const State& state = plate_.state();
    from.contacts = {plate_.lattice(), state, bodies->placed(plate_.lattice(), state, plate_.dt()),
                     options.who};
    from.contacts.find_placed(displacements_of(state));
  }
  if (!plate_.state().is_start()) {
    plate_.halt(0.0);
    from.loads = plate_.terms().actions().forces;
  }
  const double motion = View(plate_).kinetic_energy() / plate_.energy_unit();
  plate_.close_ledger();
  plate_.state().released += motion;
  return from;
}

// Of what acts at the time of the state.
StaticEquilibrium Statics::equilibrium(const RelaxOptions& options) const {
  RigidContacts contacts;
  if (const auto* bodies = plate_.terms().find<GuidedBodies>())
    contacts = {plate_.lattice(), plate_.state(),
                bodies->led(plate_.lattice(), plate_.state(), plate_.dt()), options.who};
  return {plate_.lattice(),        plate_.state(),   plate_.terms().actions(),
          plate_.thermal_strain(), plate_.threads(), std::move(contacts)};
}

// Half of the change of temperature acts in the old configuration, half in the equilibrium: exact
// while forces are linear in both.
Equilibrium Statics::go_to_rest(const Departure& from, StaticEquilibrium& equilibrium,
                                const RelaxOptions& options) {
  const std::vector<double>& heat = plate_.thermal_strain();
  const bool heats = from.heat != heat;
  equilibrium.comes_from(from.loads, from.contacts, heats ? from.heat : std::span<const double>());
  const auto heating = [&] {
    return heats ? 0.5 * heat_work(plate_.lattice(), plate_.state(), from.heat, heat,
                                   plate_.threads())
                 : 0.0;
  };
  const double before = heating();
  Equilibrium rest = settle(equilibrium, options);
  plate_.state().external_work += (before + heating()) / plate_.energy_unit();
  return rest;
}

// Moves the plate to its equilibrium and books the work.
Equilibrium Statics::settle(StaticEquilibrium& equilibrium, const RelaxOptions& options) {
  Equilibrium rest = equilibrium.solve(options);
  State& state = plate_.state();
  put(rest.u, state);
  if (const auto* bodies = plate_.terms().find<GuidedBodies>())
    bodies->stand(equilibrium.contacts().bodies(), state);
  const double unit = unit_of_work();
  state.external_work += rest.work.external * unit;
  state.released += rest.work.released * unit;
  return rest;
}

RelaxResult Statics::relax(const RelaxOptions& options) {
  check(options);
  const State before = plate_.state();
  try {
    const Departure from = depart(options);
    plate_.halt(0.0);
    StaticEquilibrium balanced = equilibrium(options);
    const RelaxResult result = go_to_rest(from, balanced, options).result;
    plate_.come_to_rest({});
    return result;
  } catch (...) {
    plate_.state() = before;
    throw;
  }
}

// A failure after bonds have broken in this increment means that the plate has come apart: the rest
// of it has no equilibrium.
void Statics::load_to(double end, const QuasistaticOptions& options, QuasistaticResult& result) {
  const State before = plate_.state();
  const std::vector<LoadedNode> borne = plate_.borne();
  const auto undo = [&] {
    plate_.restore(before);
    plate_.set_borne(borne);
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
  plate_.come_to_rest(std::move(broken_bonds));
}

RelaxOptions Statics::options_of_increment(const QuasistaticOptions& options,
                                           const QuasistaticResult& result) const {
  const int increment = static_cast<int>(result.passes.size()) - 1;
  const auto progress = [&options, &result, increment](double fraction, int) {
    if (!options.progress) return;
    const bool loads = result.passes.back() == 1;
    options.progress((increment + (loads ? fraction : 1.0)) / options.increments, increment + 1,
                     result.passes.back(), result.broken);
  };
  return {options.tolerance, progress, "quasistatic", "as it was before this increment"};
}

// The first pass loads without breaking. All later ones are jumps: prescribed motion and loads stay
// constant.
void Statics::break_and_settle(double end, const QuasistaticOptions& options,
                               QuasistaticResult& result, std::vector<BrokenBond>& broken_bonds) {
  const RelaxOptions each = options_of_increment(options, result);
  check(each);
  const Departure from = depart(each);
  const double passed = end - plate_.time();
  State& state = plate_.state();
  state.clock = {end, state.step};
  state.start = state.step;
  plate_.halt(passed);
  StaticEquilibrium balanced = equilibrium(each);
  ++result.passes.back();
  Equilibrium rest = go_to_rest(from, balanced, each);
  for (;;) {
    result.iterations += rest.result.iterations;
    const Breakage broken = break_worst(rest.beyond, state.bonds);
    if (broken.broken_bonds.empty()) return;
    state.released += broken.excess * unit_of_work();
    result.broken += std::ssize(broken.broken_bonds);
    broken_bonds.insert(broken_bonds.end(), broken.broken_bonds.begin(), broken.broken_bonds.end());
    ++result.passes.back();
    balanced.lose(broken.broken_bonds);
    rest = settle(balanced, each);
  }
}

}  // namespace hackle
