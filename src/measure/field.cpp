// SPDX-License-Identifier: MIT
#include "measure/field.hpp"

#include <algorithm>

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

// Calls visit(body, centre) for each body of the plate that has a place, the centre in m.
template <class Body, class Visit>
void for_placed(const std::vector<Body>& bodies, const std::vector<Disc>& places, const Grid& grid,
                const Visit& visit) {
  for (std::size_t k = 0; k < std::min(bodies.size(), places.size()); ++k)
    visit(bodies[k], Vec2(grid.centre + grid.dx * places[k].centre));
}

}  // namespace

std::vector<Circle> round_bodies(const View& view) {
  const Grid& grid = view.lattice().grid;
  const Loads& loads = view.plate().loads;
  std::vector<Circle> circles;
  const auto add = [&](const auto& body, const Vec2& centre) {
    circles.push_back({centre, body.radius});
  };
  for_placed(loads.impactors, view.state().discs, grid, add);
  for_placed(loads.rollers, view.state().rollers, grid, add);
  return circles;
}

std::vector<Box> platens(const View& view) {
  std::vector<Box> boxes;
  for_placed(view.plate().loads.platens, view.state().platens, view.lattice().grid,
             [&](const Platen& platen, const Vec2& centre) {
               const Vec2 half = 0.5 * (platen.to - platen.from).cwiseAbs();
               boxes.push_back({centre - half, centre + half});
             });
  return boxes;
}

}  // namespace hackle
