// SPDX-License-Identifier: MIT
#include "console/language/watcher.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "measure/field.hpp"

namespace hackle {

void call(const LuaFunction& function, const Simulation& simulation) {
  const double time = simulation.time();
  function.call({&time, 1}, {}, fmt::format("at t = {}", quantity(time, "s")));
}

DamageAlarm::DamageAlarm(LuaFunction function, const Region& area, double above,
                         const Simulation& simulation)
    : Watcher(std::move(function)), area_(simulation.lattice().grid.nodes()), above_(above) {
  const Grid& grid = simulation.lattice().grid;
  for_nodes_in(area, grid, [&](int i, int j) { area_[grid.index(i, j)] = 1; });
}

bool DamageAlarm::is_damaged(const Simulation& simulation, int i, int j) const {
  return area_[simulation.lattice().grid.index(i, j)] != 0 && damage_of(simulation, i, j) > above_;
}

// After the first check only nodes that have just lost a bond can newly exceed the value.
bool DamageAlarm::due(const Simulation& simulation) {
  if (rung_) return false;
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  bool due = false;
  if (std::exchange(at_start_, false)) {
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) due = due || is_damaged(simulation, i, j);
    return due;
  }
  const NodeLayout layout = grid.layout();
  for (const BrokenBond& broken : simulation.broken_bonds()) {
    const auto j = static_cast<int>(broken.at / layout.stride());
    const auto i = static_cast<int>(broken.at - layout.at(0, j));
    const int lost = 32 * broken.word + std::countr_zero(broken.bit);
    due = due || is_damaged(simulation, i, j);
    lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
      if (bit == lost) due = due || is_damaged(simulation, i + a, j + b);
    });
  }
  return due;
}

// A bond broken in the last step of an earlier run does not count.
bool BreakAlarm::due(const Simulation& simulation) {
  return !rung_ && simulation.time() > start_ && !simulation.broken_bonds().empty();
}

CrackAlarm::CrackAlarm(LuaFunction function, CrackEventKind kind, const Simulation& simulation)
    : Watcher(std::move(function)),
      kind_(kind),
      seen_time_(simulation.time()),
      seen_step_(simulation.state().step) {
  growth_.follow(simulation);
}

// A look at the cracks takes about 3 us for each node on them, a step 1.5 ns for each bond of the
// plate: looks take a fiftieth of a long run, and of one with few nodes on cracks what it takes.
bool CrackAlarm::is_time_to_look(const Simulation& simulation) const {
  const double horizon = growth_.m() * growth_.grid().dx;
  const double at_rest = 4.0 * horizon / growth_.rayleigh();
  const auto grown = static_cast<double>(growth_.nodes().size() - seen_nodes_);
  const bool may_rest = kind_ == CrackEventKind::arrest && growth_.time() - seen_time_ >= at_rest;
  if (!(grown >= 2.0 * growth_.m()) && !may_rest) return false;
  constexpr double bonds_per_node = 2000.0, share = 0.02, few_nodes = 1000.0, few_steps = 10.0;
  const auto nodes = static_cast<double>(growth_.nodes().size());
  const auto steps = static_cast<double>(simulation.state().step - seen_step_);
  const double bonds = steps * static_cast<double>(simulation.lattice().initial_bonds());
  return share * bonds >= bonds_per_node * nodes || (nodes < few_nodes && steps >= few_steps);
}

bool CrackAlarm::is_new(const CrackEvent& event, double horizon) const {
  return event.kind == kind_ && event.time &&
         std::ranges::none_of(known_, [&](const CrackEvent& one) {
           return (one.place - event.place).norm() < horizon;
         });
}

bool CrackAlarm::due(const Simulation& simulation) {
  growth_.follow(simulation);
  const bool last = simulation.has_arrived() && growth_.nodes().size() > seen_nodes_;
  if (growth_.empty() || !(last || is_time_to_look(simulation))) return false;
  seen_nodes_ = growth_.nodes().size();
  seen_time_ = growth_.time();
  seen_step_ = simulation.state().step;
  const double horizon = growth_.m() * growth_.grid().dx;
  const std::size_t before = known_.size();
  for (const CrackEvent& event : crack_graph(growth_).events)
    if (is_new(event, horizon)) known_.push_back(event);
  return known_.size() > before;
}

}  // namespace hackle
