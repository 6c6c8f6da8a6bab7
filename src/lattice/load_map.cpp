// SPDX-License-Identifier: MIT
#include "lattice/load_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/carve.hpp"

namespace hackle {
namespace {

using NodeForces = std::vector<LoadedNode>;

// Adds the force of a stress over a length, which is a force density, to a node. No load calls it
// twice for a node.
void push(NodeForces& forces, const Lattice& lattice, int i, int j, const Vec2& stress,
          double length) {
  const double rho = lattice.material_at(i, j).material.rho;
  forces.push_back({i, j, stress / (rho * length), rho / lattice.rho});
}

NodeForces in_order(NodeForces forces, const Grid& grid) {
  const auto index = [&](const LoadedNode& node) { return grid.index(node.i, node.j); };
  if (!std::ranges::is_sorted(forces, {}, index)) std::ranges::sort(forces, {}, index);
  return forces;
}

// Returns the value of a field at a node, after checking it.
template <class T>
T value_at(const FieldOfPlace<T>& field, const Lattice& lattice, int i, int j, const char* who) {
  const Vec2 place = lattice.grid.position(i, j);
  T value = field.at(place);
  bool finite;
  if constexpr (std::is_same_v<T, Vec2>)
    finite = value.allFinite();
  else
    finite = std::isfinite(value);
  if (finite) return value;
  throw Error(ErrorKind::refused,
              fmt::format("{}: the function gives no finite number at x = {}, y = {}", who,
                          quantity(place.x(), "m"), quantity(place.y(), "m")));
}

[[noreturn]] void refuse_empty(const char* who, const std::string& where) {
  throw Error(ErrorKind::refused, fmt::format("{}: there is no node {}", who, where),
              "give it a larger area, or a smaller spacing");
}

// Node on a line perpendicular to the edge: k counts along the edge, depth from it.
std::pair<int, int> node_at(const Grid& grid, Edge edge, int k, int depth) {
  switch (edge) {
    case Edge::left:
      return {depth, k};
    case Edge::right:
      return {grid.nx - 1 - depth, k};
    case Edge::bottom:
      return {k, depth};
    case Edge::top:
      return {k, grid.ny - 1 - depth};
  }
  return {0, 0};
}

// A line whose outermost node is void has no edge for the traction to act on.
NodeForces spread(const Traction& traction, const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  const bool along_x = traction.edge == Edge::top || traction.edge == Edge::bottom;
  const int most = along_x ? grid.ny : grid.nx;
  const int layers =
      std::clamp(static_cast<int>(std::min(std::round(traction.depth / grid.dx), 1e9)), 1, most);
  NodeForces forces;
  for (int k = 0; k < (along_x ? grid.nx : grid.ny); ++k) {
    int filled = 0;
    while (filled < layers) {
      const auto [i, j] = node_at(grid, traction.edge, k, filled);
      if (lattice.is_void(i, j)) break;
      ++filled;
    }
    if (filled == 0) continue;
    const auto [edge_i, edge_j] = node_at(grid, traction.edge, k, 0);
    const Vec2 stress = value_at(traction.stress, lattice, edge_i, edge_j, "traction");
    for (int depth = 0; depth < filled; ++depth) {
      const auto [i, j] = node_at(grid, traction.edge, k, depth);
      push(forces, lattice, i, j, stress, filled * grid.dx);
    }
  }
  if (forces.empty())
    refuse_empty("traction", fmt::format("on the {} edge", name_of(traction.edge)));
  return forces;
}

// A pressure acts on the cell faces between material and cut-out. Its resultant on a closed rim is
// 0, and its projection on any direction is exact to one cell.
NodeForces spread(const Pressure& pressure, const Plate& plate, const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  std::vector<char> open(grid.nodes());
  for (const Cutout& cutout : plate.cutouts)
    if (cutout.name == pressure.rim)
      for_nodes_in(cutout.shape, grid, [&](int i, int j) {
        open[grid.index(i, j)] = static_cast<char>(lattice.is_void(i, j));
      });
  // An outline may touch the edge of the rectangle: cells beyond it are open, too.
  const auto is_outside = [&](int i, int j) {
    return std::ranges::any_of(plate.outlines, [&](const Outline& outline) {
      return outline.name == pressure.rim && !covers(outline, grid.position(i, j), tie * grid.dx);
    });
  };
  const auto is_open = [&](int i, int j) {
    return (grid.contains(i, j) && open[grid.index(i, j)] != 0) || is_outside(i, j);
  };
  NodeForces forces;
  for_nodes(grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    Vec2 normal{0, 0};  // out of the cut-out, summed over faces
    for (const auto& [a, b] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      if (is_open(i + a, j + b)) normal -= Vec2(a, b);
    if (normal != Vec2(0, 0)) push(forces, lattice, i, j, pressure.pressure * normal, grid.dx);
  });
  if (forces.empty()) refuse_empty("pressure", fmt::format("around '{}'", pressure.rim));
  return forces;
}

NodeForces spread(const BodyForce& force, const Lattice& lattice) {
  NodeForces forces;
  for_nodes_in(force.region, lattice.grid, [&](int i, int j) {
    if (!lattice.is_void(i, j))
      push(forces, lattice, i, j, value_at(force.force, lattice, i, j, "body_force"), 1.0);
  });
  if (forces.empty()) refuse_empty("body_force", "in its area");
  return forces;
}

SpreadSupport spread(const Support& support, const Lattice& lattice) {
  SpreadSupport spread{{}, support.kind, support.amplitude};
  for_nodes_in(support.region, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    spread.nodes.push_back({i, j, value_at(support.value, lattice, i, j, "support"),
                            support.along_x, support.along_y});
  });
  if (spread.nodes.empty()) refuse_empty("support", "in its area");
  return spread;
}

SpreadHeat spread(const ThermalLoad& thermal_load, const Lattice& lattice) {
  SpreadHeat spread{nodes_of(thermal_load.region, lattice.grid), {}, thermal_load.amplitude};
  spread.strain.resize(spread.range.count());
  bool expands = false;
  for_nodes_in(thermal_load.region, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const double alphaT = lattice.material_at(i, j).material.alphaT;
    if (alphaT == 0.0) return;
    spread.strain[spread.range.index(i, j)] =
        alphaT * value_at(thermal_load.change, lattice, i, j, "temperature");
    expands = true;
  });
  if (!expands)
    throw Error(ErrorKind::refused,
                "temperature: in its area there is no node whose material expands",
                "give it a larger area, or a material with alphaT above 0");
  return spread;
}

}  // namespace

std::vector<SpreadForce> spread_forces(const Plate& plate, const Lattice& lattice) {
  std::vector<SpreadForce> forces;
  for (const Traction& load : plate.loads.tractions)
    forces.push_back({in_order(spread(load, lattice), lattice.grid), load.amplitude});
  for (const Pressure& load : plate.loads.pressures)
    forces.push_back({in_order(spread(load, plate, lattice), lattice.grid), load.amplitude});
  for (const BodyForce& load : plate.loads.body_forces)
    forces.push_back({in_order(spread(load, lattice), lattice.grid), load.amplitude});
  return forces;
}

std::vector<SpreadSupport> spread_supports(const Plate& plate, const Lattice& lattice) {
  std::vector<SpreadSupport> supports;
  for (const Support& load : plate.loads.supports) supports.push_back(spread(load, lattice));
  return supports;
}

std::vector<SpreadHeat> spread_heat(const Plate& plate, const Lattice& lattice) {
  std::vector<SpreadHeat> heat;
  for (const ThermalLoad& load : plate.loads.thermal_loads) heat.push_back(spread(load, lattice));
  return heat;
}

std::vector<LoadedNode> sum_of(std::span<const LoadedNode> one, std::span<const LoadedNode> other,
                               const Grid& grid) {
  std::vector<LoadedNode> sum;
  sum.reserve(one.size() + other.size());
  const auto index = [&](const LoadedNode& node) { return grid.index(node.i, node.j); };
  std::ranges::merge(one, other, std::back_inserter(sum), {}, index, index);
  std::size_t count = 0;
  for (const LoadedNode& node : sum) {
    if (count > 0 && index(sum[count - 1]) == index(node))
      sum[count - 1].acceleration += node.acceleration;
    else
      sum[count++] = node;
  }
  sum.resize(count);
  return sum;
}

}  // namespace hackle
