// SPDX-License-Identifier: MIT
#include "lattice/needs.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/carve.hpp"
#include "lattice/load_map.hpp"

namespace hackle {
namespace {

// The number of columns and rows, unlimited because a spacing may be absurd.
Vec2 nodes_along(const Plate& plate, const Numerics& numerics) {
  return {std::round(plate.width / numerics.spacing), std::round(plate.height / numerics.spacing)};
}

// Returns the values per place that engine and motion hold.
double values_of_place(const Needs& needs) {
  double values = 6.0;                // u, the next u and v
  if (needs.varied()) values += 2.0;  // critical stretch, threshold
  if (needs.history) values += 2.0;   // thresholds of this step and of the next
  if (needs.mixed) values += 2.0;     // stiffness, inertia
  if (needs.mixed && needs.history) values += 1.0;
  if (needs.heated) values += 1.0;
  return values;
}

// Returns the number of rows in tile_rows() without building that list.
double rows_of_tiles(int ny, int reach) {
  const int height = reach <= 8 ? 8 : 16;
  const int each_side = std::max(0, (ny / height - 1) / 2);
  const int left = ny - 2 * each_side * height;
  return 2.0 * each_side + (left >= 2 * height && left % 2 == 0 ? 2.0 : 1.0);
}

// Counts two ranges of four values and four bytes each, and three flags.
double bytes_of_tile(const Needs& needs, double real) {
  const double range = real == 4.0 ? 20.0 : 40.0;
  return 2.0 * range + 3.0 + (needs.heated ? real : 0.0);
}

double bytes_of_node(const Plate& plate, const Needs& needs) {
  double bytes = sizeof(std::uint16_t);  // initial bonds
  if (needs.kinds) bytes += sizeof(std::uint8_t);
  if (needs.scattered) bytes += sizeof(float);
  if (needs.surfaced) bytes += sizeof(float);
  if (needs.heated) bytes += sizeof(double);
  if (plate.contact) bytes += sizeof(int);
  return bytes;
}

double nodes_around(const Region& region, const Grid& grid) {
  return static_cast<double>(nodes_of(region, grid).count());
}

// The table of a function of place and time, per node: nine moments of a block of steps
// (src/lattice/README.md 7.5). Runs of more blocks take as much more.
template <class T>
double bytes_in_time(const FieldOfPlace<T>& field) {
  return field.varies_in_time() ? 9.0 * sizeof(T) : 0.0;
}

double kept(const Plate& plate, const Grid& grid, const Family& family, const Needs& needs,
            double real) {
  const NodeLayout layout = grid.layout();
  const double bits = 4.0 * family.words() * (needs.zones ? 3.0 : 2.0);
  double bytes =
      static_cast<double>(layout.size()) * (real * values_of_place(needs) + bits) +
      rows_of_tiles(grid.ny, family.reach()) * layout.groups() * bytes_of_tile(needs, real) +
      static_cast<double>(grid.nodes()) * bytes_of_node(plate, needs);
  for (const ThermalLoad& thermal_load : plate.loads.thermal_loads)
    bytes += (sizeof(double) + bytes_in_time(thermal_load.change)) *
             nodes_around(thermal_load.region, grid);
  return bytes;
}

// Counts the nodes of `layers` rows along horizontal edges, or columns along vertical ones.
double nodes_of_edge(bool along_x, double layers, const Grid& grid) {
  return along_x ? grid.nx * std::min<double>(layers, grid.ny)
                 : grid.ny * std::min<double>(layers, grid.nx);
}

// A rim has the order of the nodes around the whole lattice.
double nodes_of_edge(const Traction& traction, const Grid& grid) {
  if (!traction.edge) return 2.0 * (grid.nx + grid.ny);
  return nodes_of_edge(traction.edge == Edge::top || traction.edge == Edge::bottom,
                       std::max(1.0, std::round(traction.depth / grid.dx)), grid);
}

// Counts a layer one horizon deep along every edge.
double nodes_of_absorber(const Absorber& absorber, const Grid& grid, double m) {
  using Where = Absorber::Where;
  const bool all = absorber.edge == Where::all;
  const bool along_x = absorber.edge == Where::bottom || absorber.edge == Where::top;
  const double layers = std::ceil(m);
  return (all || along_x ? nodes_of_edge(true, layers, grid) : 0.0) * (all ? 2.0 : 1.0) +
         (all || !along_x ? nodes_of_edge(false, layers, grid) : 0.0) * (all ? 2.0 : 1.0);
}

// Counts, per node in a list of forces: the force of each load and their sum, twice, and the
// kernel's copy.
double loads(const Plate& plate, const Grid& grid, double m, double real) {
  const double force = 3.0 * sizeof(LoadedNode) + 24.0 + 3.0 * real;
  const double prescribed = sizeof(HeldNode) + 80.0 + 4.0 * real;
  double bytes = 0.0;
  for (const Traction& load : plate.loads.tractions)
    bytes += (force + bytes_in_time(load.stress)) * nodes_of_edge(load, grid);
  for (const BodyForce& load : plate.loads.body_forces)
    bytes += (force + bytes_in_time(load.force)) * nodes_around(load.region, grid);
  for (const Foundation& load : plate.loads.foundations)
    bytes += force * nodes_around(load.region, grid);
  for (const Absorber& load : plate.loads.absorbers)
    bytes += force * nodes_of_absorber(load, grid, m);
  if (plate.loads.stiffness_damping > 0.0)  // a list per row, and their union
    bytes += (force + 2.0 * sizeof(LoadedNode)) * static_cast<double>(grid.nodes());
  for (const Support& support : plate.loads.supports)
    bytes += (prescribed + bytes_in_time(support.value)) * nodes_around(support.region, grid);
  return bytes;
}

// Initial conditions: the part of each, with two components and a place, twice, and their sums.
// Changes of temperature: the strain before and after, twice, and the stiffness. The summary:
// accelerations and velocities of all places.
double passing(const Plate& plate, const Grid& grid, const Needs& needs, double real) {
  const auto nodes = static_cast<double>(grid.nodes());
  double starts = plate.initial_conditions.empty() ? 0.0 : 32.0 * nodes;
  for (const InitialCondition& start : plate.initial_conditions)
    starts += 40.0 * nodes_around(start.region, grid);
  const double heat = needs.heated ? 40.0 * nodes : 0.0;
  const double summary = 16.0 * nodes + 2.0 * real * static_cast<double>(grid.layout().size());
  return std::max({starts, heat, summary});
}

// Counts a tangent of three floats per bond, sixteen vectors of the solver, two stiffnesses per
// node, its critical stretch, fragment and part, and a copy of the previous state.
double statics(const Grid& grid, const Family& family, const Needs& needs, double real) {
  constexpr double vectors = 16.0, stiffness = 24.0;
  const double tangent = 12.0 * 0.5 * family.bonds();
  const double before = real * (needs.history ? 5.0 : 4.0) + 4.0 * family.words();
  return static_cast<double>(grid.layout().size()) *
         (tangent + vectors * 16.0 + 2.0 * stiffness + 16.0 + before);
}

}  // namespace

Needs needs_of(const Plate& plate, const Numerics& numerics) {
  const Family family(numerics.m(), numerics.quadrature, numerics.micromodulus);
  const auto materials = materials_of(plate, family, numerics);
  const bool surfaced = numerics.surface != Surface::none;
  return {.kinds = !plate.inclusions.empty() || !plate.cutouts.empty() || !plate.outlines.empty(),
          .mixed = surfaced || differ(materials),
          .surfaced = surfaced,
          .history = have_history(materials),
          .heated = !plate.loads.thermal_loads.empty(),
          .zones = !plate.no_fail.empty(),
          .scattered = plate.scatter.has_value()};
}

Needs needs_of(const Lattice& lattice, bool heated) {
  return {.kinds = !lattice.material.empty(),
          .mixed = lattice.is_mixed(),
          .surfaced = !lattice.surface.empty(),
          .history = lattice.has_history(),
          .heated = heated,
          .zones = !lattice.unbreakable.empty(),
          .scattered = !lattice.strength.empty()};
}

Memory memory_of(const Plate& plate, const Numerics& numerics) {
  const double real = numerics.precision == Precision::f32 ? 4.0 : 8.0;
  const Vec2 size = nodes_along(plate, numerics);
  if (!(size.maxCoeff() <= max_columns)) return {.kept = 8.0 * real * size.prod()};
  const Needs needs = needs_of(plate, numerics);
  const Grid grid = make_grid(plate, numerics.spacing);
  const Family family(numerics.m(), numerics.quadrature, numerics.micromodulus);
  return {.kept = kept(plate, grid, family, needs, real),
          .loads = loads(plate, grid, numerics.m(), real),
          .passing = passing(plate, grid, needs, real),
          .statics = statics(grid, family, needs, real)};
}

}  // namespace hackle
