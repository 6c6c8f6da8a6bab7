// SPDX-License-Identifier: MIT
#include "console/language/watcher.hpp"

#include <bit>

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

}  // namespace hackle
