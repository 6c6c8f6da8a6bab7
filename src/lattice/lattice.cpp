// SPDX-License-Identifier: MIT
#include "lattice/lattice.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "lattice/carve.hpp"
#include "lattice/crack_cut.hpp"
#include "lattice/scatter.hpp"
#include "lattice/surface.hpp"
#include "lattice/symbol.hpp"
#include "lattice/touching.hpp"

namespace hackle {
namespace {

BondBits uncut_bonds(const Grid& grid, const Family& family) {
  BondBits bonds(grid.layout(), family.words());
  for_nodes(grid, [&](int i, int j) {
    family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
      if (grid.contains(i + a, j + b)) bonds.set(grid.layout().at(i, j), bit);
    });
  });
  return bonds;
}

void cut_all(const std::vector<Crack>& cracks, Born how, const Grid& grid, const Family& family,
             BondBits& bonds) {
  for (const Crack& crack : cracks)
    if (crack.born == how) cut(crack, grid, family, bonds);
}

BondBits bonds_in_zones(const std::vector<Shape>& zones, const Grid& grid, const Family& family) {
  if (zones.empty()) return {};
  std::vector<char> safe_node(grid.nodes());
  for (const Shape& zone : zones)
    for_nodes_in(zone, grid, [&](int i, int j) { safe_node[grid.index(i, j)] = 1; });

  BondBits bonds(grid.layout(), family.words());
  for_nodes(grid, [&](int i, int j) {
    family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
      if (!grid.contains(i + a, j + b)) return;
      if (safe_node[grid.index(i, j)] || safe_node[grid.index(i + a, j + b)])
        bonds.set(grid.layout().at(i, j), bit);
    });
  });
  return bonds;
}

}  // namespace

std::vector<MaterialOnLattice> materials_of(const Plate& plate, const Family& family,
                                            const Numerics& numerics) {
  std::vector<MaterialOnLattice> materials;
  for (const Material& material : distinct_materials(plate))
    materials.push_back(
        {material, calibrate(family, material, numerics.spacing, numerics.constants, plate.plane)});
  return materials;
}

bool differ(const std::vector<MaterialOnLattice>& materials) {
  return std::ranges::any_of(materials, [&](const MaterialOnLattice& other) {
    const MaterialOnLattice& own = materials.front();
    return other.calibration.c != own.calibration.c || other.calibration.s0 != own.calibration.s0 ||
           other.material.rho != own.material.rho || other.material.alpha != own.material.alpha;
  });
}

bool have_history(const std::vector<MaterialOnLattice>& materials) {
  return std::ranges::any_of(
      materials, [](const MaterialOnLattice& entry) { return entry.material.alpha > 0.0; });
}

Lattice::Lattice(const Plate& plate, const Numerics& numerics)
    : grid(make_grid(plate, numerics.spacing)),
      family(numerics.m(), numerics.quadrature, numerics.micromodulus),
      materials(materials_of(plate, family, numerics)),
      material(materials_of_nodes(plate, grid)),
      calibration(materials.front().calibration),
      rho(plate.material.rho),
      step_limit(0.0),
      bonds(uncut_bonds(grid, family)),
      unbreakable(bonds_in_zones(plate.no_fail, grid, family)),
      strength(plate.scatter ? strengths(*plate.scatter, grid) : std::vector<float>()) {
  carve(plate, material, grid, family, bonds);
  const BondBits uncut = plate.contact ? bonds : BondBits();
  cut_all(plate.cracks, Born::absent, grid, family, bonds);
  initial_neighbours = degrees(grid, family, bonds);
  cut_all(plate.cracks, Born::broken, grid, family, bonds);
  surface = surface_factors(numerics.surface, grid, family, bonds);
  step_limit = hackle::step_limit(*this, plate);
  if (plate.contact)
    for_each_missing(uncut, bonds, *this, [&](const KeptBond& bond) { cut.push_back(bond); });
}

double Lattice::micromodulus_at(int i, int j) const {
  const double c = is_void(i, j) ? calibration.c : material_at(i, j).calibration.c;
  return surface.empty() ? c : c * static_cast<double>(surface[grid.index(i, j)]);
}

double Lattice::critical_stretch_at(int i, int j) const {
  const double s0 = is_void(i, j) ? calibration.s0 : material_at(i, j).calibration.s0;
  return strength.empty() ? s0 : s0 * static_cast<double>(strength[grid.index(i, j)]);
}

double Lattice::min_stretch() const {
  double min = calibration.s0;
  for (const MaterialOnLattice& entry : materials) min = std::min(min, entry.calibration.s0);
  return min;
}

std::size_t Lattice::bytes() const {
  const auto bytes_of = [](const auto& values) { return values.size() * sizeof(values.front()); };
  return bytes_of(bonds.words()) + bytes_of(unbreakable.words()) + bytes_of(initial_neighbours) +
         bytes_of(strength) + bytes_of(surface) + bytes_of(material);
}

std::int64_t Lattice::initial_bonds() const {
  return std::accumulate(initial_neighbours.begin(), initial_neighbours.end(), std::int64_t{0}) / 2;
}

double step_limit(const Lattice& lattice, const Plate& plate) {
  double c = 0.0, rho = std::numeric_limits<double>::max();
  for (const MaterialOnLattice& entry : lattice.materials) {
    c = std::max(c, entry.calibration.c);
    rho = std::min(rho, entry.material.rho);
  }
  if (!lattice.surface.empty()) c *= most_surface_factor;
  const double dx = lattice.grid.dx;
  return step_limit(lattice.family, c, rho, dx, touching_of(plate, dx));
}

std::vector<std::uint16_t> degrees(const Grid& grid, const Family& family, const BondBits& bonds) {
  std::vector<std::uint16_t> result(grid.nodes());
  const NodeLayout layout = grid.layout();
  family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    const std::uint32_t* plane =
        bonds.words().data() + static_cast<std::size_t>(bit / 32) * bonds.plane();
    const int first = std::max(0, -a), end = std::min(grid.nx, grid.nx - a);
    for (int j = 0; j + b < grid.ny; ++j) {
      const std::uint32_t* word = plane + layout.at(0, j);
      std::uint16_t* here = result.data() + grid.index(0, j);
      std::uint16_t* there = result.data() + grid.index(0, j + b) + a;
      for (int i = first; i < end; ++i) {
        const auto held = static_cast<std::uint16_t>((word[i] >> (bit & 31)) & 1U);
        here[i] = static_cast<std::uint16_t>(here[i] + held);
        there[i] = static_cast<std::uint16_t>(there[i] + held);
      }
    }
  });
  return result;
}

bool holds(const Grid& grid, const Family& family, const BondBits& bonds, int i, int j, int column,
           int row) {
  bool held = false;
  family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    if (a == column && b == row) held = bonds.holds(grid.layout().at(i, j), bit);
    if (a == -column && b == -row && grid.contains(i + column, j + row))
      held = bonds.holds(grid.layout().at(i + column, j + row), bit);
  });
  return held;
}

void isolate(const Grid& grid, const Family& family, int i, int j, BondBits& bonds) {
  bonds.clear_all(grid.layout().at(i, j));
  family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    if (grid.contains(i - a, j - b)) bonds.clear(grid.layout().at(i - a, j - b), bit);
  });
}

}  // namespace hackle
