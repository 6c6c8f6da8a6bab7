// SPDX-License-Identifier: MIT
#include "lattice/lattice.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "lattice/crack_cut.hpp"
#include "lattice/symbol.hpp"

namespace hackle {
namespace {

BondBits uncut_bonds(const Grid& grid, const Family& family) {
  BondBits bonds(grid.layout(), family.words());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
        if (grid.contains(i + a, j + b)) bonds.set(grid.layout().at(i, j), bit);
      });
  return bonds;
}

void cut_all(const std::vector<Crack>& cracks, Born born, const Grid& grid, const Family& family,
             BondBits& bonds) {
  for (const Crack& crack : cracks)
    if (crack.born == born) cut(crack, grid, family, bonds);
}

bool in_zone(const NoFail& zone, const Grid& grid, int i, int j) {
  constexpr double tie = 1e-9;
  const Vec2 node = grid.from_centre(i, j);
  const Vec2 least = grid.from_centre(zone.least), most = grid.from_centre(zone.most);
  return (node.array() >= least.array() - tie).all() && (node.array() <= most.array() + tie).all();
}

BondBits bonds_in_zones(const std::vector<NoFail>& zones, const Grid& grid, const Family& family) {
  if (zones.empty()) return {};
  const auto safe = [&](int i, int j) {
    return std::ranges::any_of(zones,
                               [&](const NoFail& zone) { return in_zone(zone, grid, i, j); });
  };
  std::vector<char> safe_node(grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) safe_node[grid.index(i, j)] = safe(i, j);

  BondBits bonds(grid.layout(), family.words());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
        if (!grid.contains(i + a, j + b)) return;
        if (safe_node[grid.index(i, j)] || safe_node[grid.index(i + a, j + b)])
          bonds.set(grid.layout().at(i, j), bit);
      });
  return bonds;
}

std::vector<LoadedNode> loaded_nodes(const std::vector<Traction>& tractions, const Grid& grid,
                                     double rho) {
  std::map<std::size_t, LoadedNode> loads;
  for (const Traction& traction : tractions) {
    const bool along_x = traction.edge == Edge::top || traction.edge == Edge::bottom;
    const bool far_side = traction.edge == Edge::top || traction.edge == Edge::right;
    for (int k = 0; k < (along_x ? grid.nx : grid.ny); ++k) {
      const int i = along_x ? k : (far_side ? grid.nx - 1 : 0);
      const int j = along_x ? (far_side ? grid.ny - 1 : 0) : k;
      LoadedNode& node =
          loads.try_emplace(grid.index(i, j), LoadedNode{i, j, {0, 0}}).first->second;
      node.acceleration += traction.stress / (rho * grid.dx);
    }
  }
  std::vector<LoadedNode> list;
  list.reserve(loads.size());
  for (const auto& entry : loads) list.push_back(entry.second);
  return list;
}

}  // namespace

Lattice::Lattice(const Plate& plate, const Numerics& numerics)
    : grid(make_grid(plate, numerics.spacing)),
      family(numerics.m(), numerics.quadrature, numerics.micromodulus),
      calibration(calibrate(family, plate.material, grid.dx, numerics.constants, plate.plane)),
      rho(plate.material.rho),
      step_limit(hackle::step_limit(family, calibration.c, rho, grid.dx)),
      bonds(uncut_bonds(grid, family)),
      unbreakable(bonds_in_zones(plate.no_fail, grid, family)),
      loads(loaded_nodes(plate.tractions, grid, rho)) {
  cut_all(plate.cracks, Born::absent, grid, family, bonds);
  born = degrees(grid, family, bonds);
  cut_all(plate.cracks, Born::broken, grid, family, bonds);
}

std::int64_t Lattice::bonds_born() const {
  return std::accumulate(born.begin(), born.end(), std::int64_t{0}) / 2;
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
