// SPDX-License-Identifier: MIT
#include "output/report/ledger_remark.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

// Returns the largest displacement of a node per step, in spacings.
double pace(const State& state) {
  double max = 0.0;
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) max = std::max(max, state.v(i, j).norm());
  return max;
}

// Returns the smallest length of a bond along a row or a column, relative to its initial length.
double min_length(const Simulation& simulation) {
  const Grid& grid = simulation.lattice().grid;
  const State& state = simulation.state();
  double min = 1.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}})
        if (grid.contains(i + a, j + b) && simulation.holds(i, j, a, b))
          min = std::min(min, (Vec2(a, b) + state.u(i + a, j + b) - state.u(i, j)).norm());
  return min;
}

// A reason for a ledger that does not close, and its signs.
struct Cause {
  std::string why;
  std::string remedy;
};

bool came_to_rest(const Simulation& simulation) {
  return simulation.state().is_start() && simulation.time() > 0.0;
}

std::string why_in_steps(const Simulation& simulation) {
  constexpr double squeezed = 0.7, fast = 0.1, strong = 0.3;
  const Loads& loads = simulation.plate().loads;
  const double moves = pace(simulation.state()), length = min_length(simulation);
  const double damping = loads.damping * simulation.dt();
  if (length < squeezed)
    return fmt::format(
        "bonds are pressed to {:.0f} % of their length, where they are stiffer than "
        "the step allows for",
        100.0 * length);
  if (!loads.impactors.empty()) return "the step is long for the impact";
  if (!loads.thermal_loads.empty()) return "the step is long for how fast the temperature changes";
  if (moves > fast) return fmt::format("nodes move by up to {:.2g} spacings in a step", moves);
  if (damping > strong)
    return fmt::format("the step is long for the damping, whose rate times the step is {:.2g}",
                       damping);
  return "the step is long for what happens";
}

Cause likely_cause(const Simulation& simulation, bool at_once) {
  if (at_once)
    return {
        "a load acts at once, and bonds break in the step that finds it, whose work is not "
        "known",
        "let it come over a time, with a ramp"};
  if (came_to_rest(simulation))
    return {"much changes in one increment of slow loading", "take more increments"};
  return {why_in_steps(simulation),
          fmt::format("what remains with simulate's step = {:.3g} or less tells",
                      0.5 * simulation.dt())};
}

double largest_entry(const Energy& energy) {
  double max = 0.0;
  for (const double entry : {energy.external, energy.kinetic, energy.strain, energy.broken,
                             energy.damped, energy.contact, energy.released})
    max = std::max(max, std::abs(entry));
  return max;
}

// Returns the energy, J/m, below which a ledger is empty: rounding, for a plate that only moves;
// the nonlinear part of the stretch, on which heat does work, for a plate that is only heated. One
// that heat has broken is more than that.
double nothing(const Simulation& simulation, const Energy& energy) {
  constexpr double rounding = 1e-9;
  const Lattice& lattice = simulation.lattice();
  double motion = 0.0, heat = 0.0;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      motion = std::max(motion, simulation.displacement(i, j).squaredNorm());
  for (const double strain : simulation.thermal_strain())
    heat += 2.0 * std::pow(std::abs(strain), 3) * lattice.grid.dx * lattice.grid.dx;
  if (energy.broken > 0.0) heat = 0.0;
  return simulation.plate().material.E * (rounding * motion + heat);
}

}  // namespace

double residual_share(const Energy& energy) {
  const double max = largest_entry(energy);
  return max > 0.0 ? energy.residual() / max : 0.0;
}

std::optional<std::string> ledger_remark(const Simulation& simulation, const Energy& energy,
                                         bool at_once) {
  const double share = residual_share(energy);
  if (!(std::abs(share) > max_residual)) return std::nullopt;
  if (largest_entry(energy) < nothing(simulation, energy)) return std::nullopt;
  const Cause cause = likely_cause(simulation, at_once);
  return fmt::format(
      "the energies do not add up: {:.2g} % of the largest {}. A likely cause: {}; {}",
      100.0 * std::abs(share), share > 0.0 ? "is lost" : "comes from nowhere", cause.why,
      cause.remedy);
}

}  // namespace hackle
