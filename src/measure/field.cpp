// SPDX-License-Identifier: MIT
#include "measure/field.hpp"

#include <optional>

namespace hackle {
namespace {

// Makes a field of two components from a vector per node, given by its column and row.
template <class Of>
Field vector_field(const View& view, const char* name, const char* unit, Of of) {
  const Grid& grid = view.lattice().grid;
  Field field{name, unit, 2, {}};
  field.values.reserve(2 * grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 value = of(i, j);
      field.values.push_back(static_cast<float>(value.x()));
      field.values.push_back(static_cast<float>(value.y()));
    }
  return field;
}

// Computes damage from the number of intact bonds.
Field damage_by(const BondBits& bonds, const Lattice& lattice) {
  const auto left = degrees(lattice.grid, lattice.family, bonds);
  Field field{"damage", "", 1, std::vector<float>(lattice.grid.nodes())};
  for (std::size_t node = 0; node < field.values.size(); ++node) {
    const int initial_neighbours = lattice.initial_neighbours[node];
    field.values[node] = initial_neighbours == 0
                             ? 0.0F
                             : static_cast<float>(initial_neighbours - left[node]) /
                                   static_cast<float>(initial_neighbours);
  }
  return field;
}

}  // namespace

Field damage(const View& view) {
  return damage_by(view.state().bonds, view.lattice());
}

Field damage_at_start(const View& view) {
  return damage_by(view.lattice().bonds, view.lattice());
}

double damage_of(const View& view, int i, int j) {
  const Lattice& lattice = view.lattice();
  const Grid& grid = lattice.grid;
  const BondBits& bonds = view.state().bonds;
  const NodeLayout layout = grid.layout();
  int left = 0;
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    left += bonds.holds(layout.at(i, j), bit) ? 1 : 0;
    left += grid.contains(i - a, j - b) && bonds.holds(layout.at(i - a, j - b), bit) ? 1 : 0;
  });
  const int initial_neighbours = lattice.initial_neighbours[grid.index(i, j)];
  return initial_neighbours == 0
             ? 0.0
             : static_cast<double>(initial_neighbours - left) / initial_neighbours;
}

double temperature_of(const View& view, int i, int j) {
  const std::vector<double>& strain = view.thermal_strain();
  const Lattice& lattice = view.lattice();
  if (strain.empty() || lattice.is_void(i, j)) return 0.0;
  const double alphaT = lattice.material_at(i, j).material.alphaT;
  return alphaT == 0.0 ? 0.0 : strain[lattice.grid.index(i, j)] / alphaT;
}

Field displacement(const View& view) {
  return vector_field(view, "displacement", "m", [&](int i, int j) -> Vec2 {
    if (view.lattice().is_void(i, j)) return {0, 0};
    return view.displacement(i, j);
  });
}

Field velocity(const View& view) {
  const std::vector<Vec2> velocities = view.velocities();
  const Grid& grid = view.lattice().grid;
  return vector_field(view, "velocity", "m/s",
                      [&](int i, int j) { return velocities[grid.index(i, j)]; });
}

namespace {

// Returns where a roller is; where its amplitude is a function, which a recording does not know,
// nothing.
std::optional<Vec2> place_of(const Roller& roller, double time) {
  if (roller.amplitude.is_function()) return std::nullopt;
  const double factor = roller.guide == Guide::displacement
                            ? roller.amplitude.at(time)
                            : time * roller.amplitude.mean(0.0, time);
  return roller.centre + factor * roller.value;
}

}  // namespace

std::vector<Circle> impactors(const View& view) {
  const Grid& grid = view.lattice().grid;
  std::vector<Circle> circles;
  for (std::size_t k = 0; k < view.state().discs.size(); ++k)
    circles.push_back({grid.centre + grid.dx * view.state().discs[k].centre,
                       view.plate().loads.impactors[k].radius});
  for (const Roller& roller : view.plate().loads.rollers)
    if (const std::optional<Vec2> centre = place_of(roller, view.time()))
      circles.push_back({*centre, roller.radius});
  return circles;
}

}  // namespace hackle
