// SPDX-License-Identifier: MIT
// What acts on one node, without a look at the others.
#pragma once

#include <algorithm>
#include <span>

#include "lattice/lattice.hpp"
#include "solver/state.hpp"

namespace hackle {

// Returns the entry of a node in a list that is ordered by index, or nullptr.
template <class Entry>
const Entry* entry_of(std::span<const Entry> list, int i, int j, const Grid& grid) {
  const auto index = [&](const Entry& entry) { return grid.index(entry.i, entry.j); };
  const auto found = std::ranges::lower_bound(list, grid.index(i, j), {}, index);
  return found != list.end() && index(*found) == grid.index(i, j) ? &*found : nullptr;
}

// Returns the acceleration of a node by its bonds, in lattice units (src/solver/README.md 2.2), for
// steps of dt; 0 where void. `heat` is the thermal strain by Grid::index. A bond that the next step
// breaks still pulls.
Vec2 pull_of_bonds(const Lattice& lattice, const State& state, const std::vector<double>& heat,
                   double dt, int i, int j);

}  // namespace hackle
