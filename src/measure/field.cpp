// SPDX-License-Identifier: MIT
#include "measure/field.hpp"

namespace hackle {
namespace {

// Calls visit(node, in_u) for every node: its index and its place in the rimmed arrays.
template <class Visit>
void for_each_node(const Simulation& simulation, Visit visit) {
  const Grid& grid = simulation.lattice().grid;
  const Rimmed& layout = simulation.state().layout;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      visit(grid.index(i, j), static_cast<std::size_t>(layout.at(i, j)));
}

}  // namespace

Field damage(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  Field field{"damage", "", 1, std::vector<float>(lattice.grid.nodes())};
  for (std::size_t node = 0; node < field.values.size(); ++node) {
    const int born = lattice.born[node];
    const int left = simulation.state().bonds.count(node);
    field.values[node] =
        born == 0 ? 0.0F : static_cast<float>(born - left) / static_cast<float>(born);
  }
  return field;
}

Field displacement(const Simulation& simulation) {
  const State& state = simulation.state();
  const double dx = simulation.lattice().grid.dx;
  Field field{"displacement", "m", 2, std::vector<float>(2 * simulation.lattice().grid.nodes())};
  for_each_node(simulation, [&](std::size_t node, std::size_t in_u) {
    field.values[2 * node] = static_cast<float>(state.ux[in_u] * dx);
    field.values[2 * node + 1] = static_cast<float>(state.uy[in_u] * dx);
  });
  return field;
}

Field velocity(const Simulation& simulation) {
  const State& state = simulation.state();
  const double unit = simulation.lattice().grid.dx / simulation.dt();
  Field field{"velocity", "m/s", 2, std::vector<float>(2 * simulation.lattice().grid.nodes())};
  for (std::size_t node = 0; node < state.vx.size(); ++node) {
    field.values[2 * node] = static_cast<float>(state.vx[node] * unit);
    field.values[2 * node + 1] = static_cast<float>(state.vy[node] * unit);
  }
  return field;
}

}  // namespace hackle
