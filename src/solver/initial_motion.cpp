// SPDX-License-Identifier: MIT
#include "solver/initial_motion.hpp"

#include "lattice/carve.hpp"
#include "solver/exact_sum.hpp"
#include "solver/meetings.hpp"

namespace hackle {
namespace {

// The initial condition of some nodes, in lattice units.
struct SpreadCondition {
  std::vector<std::size_t> at;  // Grid::index
  std::vector<Vec2> u, v;
};

SpreadCondition spread(const InitialCondition& start, const Lattice& lattice, double dt) {
  SpreadCondition spread;
  for_nodes_in(start.region, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const Vec2 place = lattice.grid.position(i, j);
    spread.at.push_back(lattice.grid.index(i, j));
    spread.u.push_back(start.displacement.at(place) / lattice.grid.dx);
    spread.v.push_back(start.velocity.at(place) * (dt / lattice.grid.dx));
  });
  return spread;
}

// Returns the sum of one quantity over all initial conditions, by Grid::index.
std::vector<Vec2> sum_of(const std::vector<SpreadCondition>& starts,
                         std::vector<Vec2> SpreadCondition::*quantity,
                         const std::vector<Meeting>& crowds, const Grid& grid) {
  std::vector<Vec2> sum(grid.nodes(), Vec2(0, 0));
  for (const SpreadCondition& start : starts)
    for (std::size_t k = 0; k < start.at.size(); ++k) sum[start.at[k]] += (start.*quantity)[k];
  for (const Meeting& crowd : crowds) {
    ExactVectorSum exact;
    for (const auto& [start, entry] : crowd.entries) exact.add((starts[start].*quantity)[entry]);
    sum[crowd.place] = exact.value();
  }
  return sum;
}

}  // namespace

void set_in_motion(const std::vector<InitialCondition>& conditions, const Lattice& lattice,
                   double dt, State& state) {
  if (conditions.empty()) return;
  const Grid& grid = lattice.grid;
  std::vector<SpreadCondition> spreads;
  spreads.reserve(conditions.size());
  for (const InitialCondition& start : conditions) spreads.push_back(spread(start, lattice, dt));
  std::vector<const std::vector<std::size_t>*> lists;
  lists.reserve(spreads.size());
  for (const SpreadCondition& start : spreads) lists.push_back(&start.at);
  const std::vector<Meeting> crowds = find_meetings(lists, grid.nodes());
  const std::vector<Vec2> u = sum_of(spreads, &SpreadCondition::u, crowds, grid),
                          v = sum_of(spreads, &SpreadCondition::v, crowds, grid);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      state.set_u(i, j, u[grid.index(i, j)]);
      state.set_v(i, j, v[grid.index(i, j)]);
    }
}

}  // namespace hackle
