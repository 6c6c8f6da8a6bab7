// SPDX-License-Identifier: MIT
#include "output/report/shape_remarks.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/carve.hpp"

namespace hackle {
namespace {

bool removes_a_node(const Cutout& cutout, const Grid& grid) {
  bool removes = false;
  const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
  for_nodes_in(cutout.shape, grid, [&](int i, int j) {
    removes = removes || is_inside(shape, grid.from_centre(i, j), tie);
  });
  return removes;
}

bool cuts_a_bond(const Cutout& cutout, const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
  const NodeRange range = nodes_near(bounds(shape), grid, lattice.family.reach());
  bool cut = false;
  for (int j = range.first_j; j <= range.last_j && !cut; ++j)
    for (int i = range.first_i; i <= range.last_i && !cut; ++i)
      lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
        cut = cut || (grid.contains(i + a, j + b) &&
                      cuts(shape, {grid.from_centre(i, j), grid.from_centre(i + a, j + b)}, tie));
      });
  return cut;
}

std::string label(const Cutout& cutout, std::size_t number) {
  const std::string name = cutout.name.empty() ? "" : fmt::format(" '{}'", cutout.name);
  return fmt::format("cut-out {}{} ({})", number, name, kind_of(cutout.shape));
}

void add_cutouts(const Plate& plate, const Lattice& lattice, std::vector<std::string>& list) {
  const std::string spacing = quantity(lattice.grid.dx, "m");
  for (std::size_t k = 0; k < plate.cutouts.size(); ++k) {
    const Cutout& cutout = plate.cutouts[k];
    if (removes_a_node(cutout, lattice.grid)) continue;
    if (cuts_a_bond(cutout, lattice))
      list.push_back(fmt::format(
          "{} is thinner than the spacing of {}: it removes no node and works as a crack",
          label(cutout, k + 1), spacing));
    else
      list.push_back(fmt::format("{} is so small that it changes nothing at a spacing of {}",
                                 label(cutout, k + 1), spacing));
  }
}

void add_inclusions(const Plate& plate, const Lattice& lattice, std::vector<std::string>& list) {
  for (std::size_t k = 0; k < plate.inclusions.size(); ++k) {
    bool found = false;
    for_nodes_in(plate.inclusions[k].shape, lattice.grid, [&](int, int) { found = true; });
    if (!found)
      list.push_back(fmt::format("inclusion {} covers no node at a spacing of {}", k + 1,
                                 quantity(lattice.grid.dx, "m")));
  }
}

void add_loose_nodes(const Lattice& lattice, std::vector<std::string>& list) {
  std::int64_t loose = 0;
  for (std::size_t node = 0; node < lattice.initial_neighbours.size(); ++node)
    if (lattice.initial_neighbours[node] == 0 &&
        (lattice.material.empty() || lattice.material[node] != Lattice::void_node))
      ++loose;
  if (loose > 0)
    list.push_back(
        fmt::format("{} node{} left without any bond", loose, loose == 1 ? " is" : "s are"));
}

}  // namespace

std::vector<std::string> shape_remarks(const Plate& plate, const Lattice& lattice) {
  std::vector<std::string> list;
  add_cutouts(plate, lattice, list);
  add_inclusions(plate, lattice, list);
  if (!plate.cutouts.empty() || !plate.outlines.empty()) add_loose_nodes(lattice, list);
  return list;
}

}  // namespace hackle
