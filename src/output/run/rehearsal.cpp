// SPDX-License-Identifier: MIT
#include "output/run/rehearsal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "lattice/needs.hpp"

namespace hackle {
namespace {

constexpr std::int64_t max_nodes_tried = 4'000'000;
constexpr double trial_seconds = 0.2;
constexpr double drift = 1e-7;  // spacings per step

// Sets every tile in motion: still tiles cost nothing, but a breaking plate has none.
State in_motion(const Simulation& simulation) {
  State state = simulation.state();
  const Lattice& lattice = simulation.lattice();
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j)) state.set_v(i, j, {drift, drift});
  return state;
}

double try_steps(const Simulation& simulation) {
  if (static_cast<std::int64_t>(simulation.lattice().grid.nodes()) > max_nodes_tried) return 0.0;
  Simulation trial = simulation;
  trial.restore(in_motion(simulation));
  trial.step();  // fills the caches
  double seconds = 0.0;
  int steps = 0;
  while (seconds < trial_seconds) {
    const Stopwatch watch(seconds);
    trial.step();
    ++steps;
  }
  return seconds / steps;
}

std::string wall_time(const Rehearsal& rehearsal) {
  if (rehearsal.step_seconds <= 0.0) return "not tried";
  return fmt::format("about {:.3g} s to solve, {:.3g} ms a step",
                     rehearsal.step_seconds * static_cast<double>(rehearsal.steps),
                     1e3 * rehearsal.step_seconds) +
         (rehearsal.increments > 0
              ? fmt::format(", and slow loading in {} increments", rehearsal.increments)
              : "");
}

// With a doubt, a certain break stays certain; nothing else is.
std::string verdict(const Rehearsal& rehearsal) {
  std::string known = describe(rehearsal.forecast);
  if (rehearsal.doubts.empty() && rehearsal.looked &&
      rehearsal.forecast.verdict() != Forecast::Verdict::breaks)
    return known +
           "\n           that is, unless the script does more when it sees results, which are not "
           "there";
  if (rehearsal.doubts.empty()) return known;
  const std::string unknown = fmt::format("unknown: {}", fmt::join(rehearsal.doubts, "; "));
  switch (rehearsal.forecast.verdict()) {
    case Forecast::Verdict::nothing_loads_it:
      return unknown + "; else nothing loads it";
    case Forecast::Verdict::breaks:
      return fmt::format("{}\n           also {}", known, unknown);
    default:
      return fmt::format("{}\n           that is, of what is known; {}", known, unknown);
  }
}

}  // namespace

Rehearsal rehearse(const Simulation& simulation, const Prospect& prospect) {
  Rehearsal found;
  found.nodes = static_cast<std::int64_t>(simulation.lattice().grid.nodes());
  found.bonds = simulation.lattice().initial_bonds();
  const Memory memory = memory_of(simulation.plate(), simulation.numerics());
  found.memory = memory.all() + (prospect.rests() ? memory.statics : 0.0);
  found.dt = simulation.dt();
  found.dt_limit = simulation.lattice().step_limit;
  found.steps = prospect.steps();
  found.increments = prospect.increments();
  found.time = static_cast<double>(found.steps) * simulation.dt();
  found.step_seconds = try_steps(simulation);
  found.forecast = prospect.worst(simulation);
  found.looked = prospect.looked();
  found.doubts.assign(prospect.doubts().begin(), prospect.doubts().end());
  return found;
}

std::string describe(const Rehearsal& rehearsal) {
  return fmt::format(
      "  lattice  {} nodes, {} bonds, {}\n"
      "  time     {} in {} steps of {} (limit {})\n"
      "  wall     {}\n"
      "  breaks?  {}",
      grouped(rehearsal.nodes), grouped(rehearsal.bonds), quantity(rehearsal.memory, "B"),
      quantity(rehearsal.time, "s"), grouped(rehearsal.steps), quantity(rehearsal.dt, "s"),
      quantity(rehearsal.dt_limit, "s"), wall_time(rehearsal), verdict(rehearsal));
}

}  // namespace hackle
