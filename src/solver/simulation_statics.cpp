// SPDX-License-Identifier: MIT
// How a simulation comes to rest.
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "solver/bond_energy.hpp"
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

void Simulation::check_statics() const {
  if (!plate_.loads.heatings.empty())
    throw Error(ErrorKind::refused, "relax: a plate that is heated cannot be brought to rest",
                "leave out the heat, or let damping calm the plate");
  if (!plate_.loads.impactors.empty())
    throw Error(ErrorKind::refused, "relax: a plate that is being hit cannot be brought to rest",
                "bring it to rest before s:impactor{}, or let damping calm it");
}

Equilibrium Simulation::find_rest(const RelaxOptions& options) {
  check_statics();
  loading_.halt(state_);
  return Relaxation(lattice_, state_, loading_, threads_).solve(options);
}

void Simulation::put(const NodeVectors& u) {
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i) {
      const auto at = static_cast<std::size_t>(state_.layout.at(i, j));
      state_.set_u(i, j, {u.x[at], u.y[at]});
    }
}

// Loaded slowly, all work is in the bonds, has broken some, or went before.
void Simulation::come_to_rest() {
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i) state_.set_v(i, j, {0, 0});
  state_.start = state_.step;
  const BondEnergy bonds = bond_energy(lattice_, state_);
  state_.external_work = (bonds.held + bonds.broken) / energy_unit() + state_.damped;
  state_.work_ahead = 0.0;
  if (state_.precision() == Precision::f32) keep_f32_exact();
  prepare();
}

RelaxResult Simulation::relax(const RelaxOptions& options) {
  check_tolerance(options.tolerance, "relax");
  const Equilibrium rest = find_rest(options);
  put(rest.u);
  come_to_rest();
  return rest.result;
}

QuasistaticResult Simulation::load_slowly(const QuasistaticOptions& options,
                                          std::span<Observer* const> observers) {
  check_tolerance(options.tolerance, "quasistatic");
  if (!(options.duration > 0.0) || !std::isfinite(options.duration) || options.increments < 1)
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: {} s in {} increments; there must be more than 0 s and at "
                    "least 1 increment",
                    options.duration, options.increments));
  const double begin = time();
  if (!(begin + options.duration <= most_steps * dt_))
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: the duration is {}, which is more than {:.0e} steps of {}",
                    quantity(options.duration, "s"), most_steps, quantity(dt_, "s")));
  QuasistaticResult result;
  let_look(observers);
  for (int k = 1; k <= options.increments && result.bears; ++k) {
    const double end = begin + options.duration * k / options.increments;
    load_to(std::llround(end / dt_), options, result);
    let_look(observers);
  }
  return result;
}

// A failure after bonds have broken in this increment means that the plate has come apart: what is
// left of it cannot be in balance.
void Simulation::load_to(std::int64_t step, const QuasistaticOptions& options,
                         QuasistaticResult& result) {
  const State before = state_;
  const int increment = static_cast<int>(result.passes.size());
  result.passes.push_back(0);
  state_.step = state_.start = step;
  try {
    for (std::int64_t broken = 1; broken > 0; result.broken += broken) {
      const int pass = ++result.passes.back();
      const Equilibrium rest =
          find_rest({options.tolerance, [&](double fraction, int) {
                       if (!options.progress) return;
                       const double done =
                           (increment + (pass == 1 ? fraction : 1.0)) / options.increments;
                       options.progress(done, increment + 1, pass, result.broken);
                     }});
      result.iterations += rest.result.iterations;
      put(rest.u);
      broken = break_worst(rest.beyond, state_.bonds);
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted || result.passes.back() == 1) {
      restore(before);
      throw;
    }
    result.bears = false;
    result.why = error.what();
  }
  come_to_rest();
  stop();
}

}  // namespace hackle
