// SPDX-License-Identifier: MIT
#include "lattice/load_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "lattice/rim_shares.hpp"

namespace hackle {
namespace {

// A node that a field acts on: its acceleration is the field at `place` over `resistance`.
struct FieldNode {
  LoadedNode node;
  Vec2 place{0, 0};         // m
  double resistance = 1.0;  // of a stress, density times a length
};
using FieldNodes = std::vector<FieldNode>;

// Adds a node on which a stress over a length acts, which is a force density. No load calls it
// twice for a node.
void add_node(FieldNodes& nodes, const Lattice& lattice, int i, int j, const Vec2& place,
              double length) {
  const double rho = lattice.material_at(i, j).material.rho;
  nodes.push_back({{i, j, {0, 0}, rho / lattice.rho}, place, rho * length});
}

bool is_finite(double value) {
  return std::isfinite(value);
}
bool is_finite(const Vec2& value) {
  return value.allFinite();
}

// Returns the value of a field at a place, after checking it.
template <class T>
T value_at(const FieldOfPlace<T>& field, const Vec2& place, double t, std::string_view who) {
  T value = field.at(place, t);
  if (is_finite(value)) return value;
  throw Error(ErrorKind::refused,
              fmt::format("{}: the function gives no finite number at x = {}, y = {}{}", who,
                          quantity(place.x(), "m"), quantity(place.y(), "m"),
                          field.varies_in_time() ? ", t = " + quantity(t, "s") : ""));
}

template <class T>
std::vector<T> all_values_at(const Course<T>& course, double t) {
  std::vector<T> values;
  values.reserve(course.places.size());
  for (std::size_t k = 0; k < course.places.size(); ++k) {
    if (k % 1024 == 0) throw_if_interrupted();
    values.push_back(value_at(course.field, course.places[k], t, course.who) / course.divisors[k]);
  }
  return values;
}

// Begins the course of a field; with no places if it does not vary in time.
template <class T>
void add_to_course(Course<T>& course, const FieldOfPlace<T>& field, const Vec2& place,
                   double divisor) {
  if (!field.varies_in_time()) return;
  course.places.push_back(place);
  course.divisors.push_back(divisor);
}

[[noreturn]] void refuse_empty(const char* who, const std::string& where) {
  throw Error(ErrorKind::refused, fmt::format("{}: there is no node {}", who, where),
              "give it a larger area, or a smaller spacing");
}

SpreadForce spread(const VectorField& field, FieldNodes nodes, const Amplitude& amplitude,
                   const Grid& grid, const char* who) {
  const auto index = [&](const FieldNode& entry) { return grid.index(entry.node.i, entry.node.j); };
  std::ranges::sort(nodes, {}, index);
  SpreadForce force{{}, amplitude, {field, who, {}, {}}};
  for (FieldNode& entry : nodes) {
    entry.node.acceleration = value_at(field, entry.place, 0.0, who) / entry.resistance;
    force.nodes.push_back(entry.node);
    add_to_course(force.course, field, entry.place, entry.resistance);
  }
  return force;
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
FieldNodes nodes_at(Edge edge, double depth, const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  const bool along_x = edge == Edge::top || edge == Edge::bottom;
  const int max = along_x ? grid.ny : grid.nx;
  const int layers =
      std::clamp(static_cast<int>(std::min(std::round(depth / grid.dx), 1e9)), 1, max);
  FieldNodes nodes;
  for (int k = 0; k < (along_x ? grid.nx : grid.ny); ++k) {
    int filled = 0;
    while (filled < layers) {
      const auto [i, j] = node_at(grid, edge, k, filled);
      if (lattice.is_void(i, j)) break;
      ++filled;
    }
    const auto [edge_i, edge_j] = node_at(grid, edge, k, 0);
    for (int layer = 0; layer < filled; ++layer) {
      const auto [i, j] = node_at(grid, edge, k, layer);
      add_node(nodes, lattice, i, j, grid.position(edge_i, edge_j), filled * grid.dx);
    }
  }
  if (nodes.empty()) refuse_empty("traction", fmt::format("on the {} edge", name_of(edge)));
  return nodes;
}

FieldNodes nodes_around(const Traction& traction, const Plate& plate, const Lattice& lattice) {
  FieldNodes nodes;
  for (const RimShare& share : shares_of_rims(plate, lattice, traction.rim, traction.angles))
    add_node(nodes, lattice, share.i, share.j, share.middle, lattice.grid.dx / share.length);
  if (nodes.empty()) refuse_empty("traction", fmt::format("around '{}'", traction.rim));
  return nodes;
}

SpreadForce spread(const Traction& load, const Plate& plate, const Lattice& lattice) {
  return spread(
      load.stress,
      load.edge ? nodes_at(*load.edge, load.depth, lattice) : nodes_around(load, plate, lattice),
      load.amplitude, lattice.grid, "traction");
}

using NodeForces = std::vector<LoadedNode>;

// `push` is the pressure times the normal into the material, per spacing of the rim that a node
// has.
void add_push(NodeForces& forces, const Lattice& lattice, int i, int j, const Vec2& push) {
  const double rho = lattice.material_at(i, j).material.rho;
  forces.push_back({i, j, push / (rho * lattice.grid.dx), rho / lattice.rho});
}

// A pressure around a whole rim acts on the cell faces between material and cut-out. Its resultant
// on a closed rim is 0, and its projection on any direction is exact to one cell.
NodeForces push_cells(const Pressure& pressure, const Plate& plate, const Lattice& lattice) {
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
    if (normal != Vec2(0, 0)) add_push(forces, lattice, i, j, pressure.pressure * normal);
  });
  return forces;
}

NodeForces push_shares(const Pressure& pressure, const std::vector<RimShare>& shares,
                       const Lattice& lattice) {
  NodeForces forces;
  for (const RimShare& share : shares)
    add_push(forces, lattice, share.i, share.j, pressure.pressure * share.normal);
  return forces;
}

SpreadForce spread(const Pressure& load, const Plate& plate, const Lattice& lattice) {
  const NodeForces rims =
      load.angles
          ? push_shares(load, shares_of_rims(plate, lattice, load.rim, load.angles), lattice)
          : push_cells(load, plate, lattice);
  const NodeForces faces =
      push_shares(load, shares_of_cracks(plate, lattice, load.rim, load.angles), lattice);
  NodeForces forces = faces.empty() ? rims : sum_of(rims, faces, lattice.grid);
  if (forces.empty()) refuse_empty("pressure", fmt::format("around '{}'", load.rim));
  return {std::move(forces), load.amplitude, {}};
}

SpreadForce spread(const BodyForce& load, const Lattice& lattice) {
  FieldNodes nodes;
  for_nodes_in(load.region, lattice.grid, [&](int i, int j) {
    if (!lattice.is_void(i, j)) add_node(nodes, lattice, i, j, lattice.grid.position(i, j), 1.0);
  });
  if (nodes.empty()) refuse_empty("body_force", "in its area");
  return spread(load.force, std::move(nodes), load.amplitude, lattice.grid, "body_force");
}

SpreadSupport spread(const Support& support, const Lattice& lattice) {
  SpreadSupport spread{{}, support.kind, support.amplitude, {support.value, "support", {}, {}}};
  for_nodes_in(support.region, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const Vec2 place = lattice.grid.position(i, j);
    spread.nodes.push_back(
        {i, j, value_at(support.value, place, 0.0, "support"), support.along_x, support.along_y});
    add_to_course(spread.course, support.value, place, 1.0);
  });
  if (spread.nodes.empty()) refuse_empty("support", "in its area");
  return spread;
}

SpreadHeat spread(const ThermalLoad& thermal_load, const Lattice& lattice) {
  const ScalarField& change = thermal_load.change;
  SpreadHeat spread{nodes_of(thermal_load.region, lattice.grid),
                    {},
                    thermal_load.amplitude,
                    {change, "temperature", {}, {}}};
  spread.strain.resize(spread.range.count());
  bool expands = false;
  for_nodes_in(thermal_load.region, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const double alphaT = lattice.material_at(i, j).material.alphaT;
    if (alphaT == 0.0) return;
    const Vec2 place = lattice.grid.position(i, j);
    const std::size_t at = spread.range.index(i, j);
    spread.strain[at] = alphaT * value_at(change, place, 0.0, "temperature");
    add_to_course(spread.course, change, place, 1.0 / alphaT);
    if (change.varies_in_time()) spread.at.push_back(at);
    expands = true;
  });
  if (!expands)
    throw Error(ErrorKind::refused,
                "temperature: in its area there is no node whose material expands",
                "give it a larger area, or a material with alphaT above 0");
  return spread;
}

}  // namespace

std::vector<Vec2> values_at(const Course<Vec2>& course, double t) {
  return all_values_at(course, t);
}

std::vector<double> values_at(const Course<double>& course, double t) {
  return all_values_at(course, t);
}

std::vector<SpreadForce> spread_forces(const Plate& plate, const Lattice& lattice) {
  std::vector<SpreadForce> forces;
  for (const Traction& load : plate.loads.tractions) forces.push_back(spread(load, plate, lattice));
  for (const Pressure& load : plate.loads.pressures) forces.push_back(spread(load, plate, lattice));
  for (const BodyForce& load : plate.loads.body_forces) forces.push_back(spread(load, lattice));
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
