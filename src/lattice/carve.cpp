// SPDX-License-Identifier: MIT
#include "lattice/carve.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace hackle {

NodeRange nodes_near(const Box& box, const Grid& grid, int margin) {
  const auto range = [margin](double min, double max, int n) {
    const double middle = 0.5 * (n - 1), last = n - 1;
    const double from = std::floor(std::clamp(min + middle, -1.0, last + 1.0)) - margin;
    const double to = std::ceil(std::clamp(max + middle, -1.0, last + 1.0)) + margin;
    return std::pair{static_cast<int>(std::max(from, 0.0)), static_cast<int>(std::min(to, last))};
  };
  const auto [first_i, last_i] = range(box.min.x(), box.max.x(), grid.nx);
  const auto [first_j, last_j] = range(box.min.y(), box.max.y(), grid.ny);
  return {first_i, last_i, first_j, last_j};
}

NodeRange nodes_of(const Region& region, const Grid& grid) {
  if (!region) return {0, grid.nx - 1, 0, grid.ny - 1};
  return nodes_near(bounds(transformed(*region, grid.centre, 1.0 / grid.dx)), grid, 1);
}

std::vector<Material> distinct_materials(const Plate& plate) {
  std::vector<Material> list{plate.material};
  for (const Inclusion& inclusion : plate.inclusions)
    if (std::ranges::find(list, inclusion.material) == list.end())
      list.push_back(inclusion.material);
  return list;
}

std::vector<std::uint8_t> materials_of_nodes(const Plate& plate, const Grid& grid) {
  if (plate.cutouts.empty() && plate.outlines.empty() && plate.inclusions.empty()) return {};
  const std::vector<Material> materials = distinct_materials(plate);
  std::vector<std::uint8_t> material(grid.nodes());
  for (const Inclusion& inclusion : plate.inclusions) {
    const auto kind = static_cast<std::uint8_t>(std::ranges::find(materials, inclusion.material) -
                                                materials.begin());
    for_nodes_in(inclusion.shape, grid, [&](int i, int j) { material[grid.index(i, j)] = kind; });
  }
  for (const Cutout& cutout : plate.cutouts) {
    const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
    for_nodes(nodes_near(bounds(shape), grid, 1), [&](int i, int j) {
      if (is_inside(shape, grid.from_centre(i, j), tie)) material[grid.index(i, j)] = void_node;
    });
  }
  for (const Outline& outline : plate.outlines) {
    const Outline scaled = transformed(outline, grid.centre, 1.0 / grid.dx);
    for_nodes(grid, [&](int i, int j) {
      if (!covers(scaled, grid.from_centre(i, j), tie)) material[grid.index(i, j)] = void_node;
    });
  }
  if (std::ranges::count(material, void_node) == static_cast<std::ptrdiff_t>(material.size()))
    throw Error(ErrorKind::refused, "plate: its cut-outs and outlines leave no node of it",
                "make cut-outs smaller, outlines larger, or the spacing finer");
  return material;
}

namespace {

// Clears the bonds of node (i, j) for which cut(segment) is true, in lattice units.
template <class Cut>
void clear_at(int i, int j, const Grid& grid, const Family& family, BondBits& bonds,
              const Cut& cut) {
  const Vec2 here = grid.from_centre(i, j);
  family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    if (grid.contains(i + a, j + b) && cut(Segment{here, grid.from_centre(i + a, j + b)}))
      bonds.clear(grid.layout().at(i, j), bit);
  });
}

void clear_void(const NodeRange& range, const std::vector<std::uint8_t>& material, const Grid& grid,
                const Family& family, BondBits& bonds) {
  const auto is_void = [&](int i, int j) { return material[grid.index(i, j)] == void_node; };
  for_nodes(range, [&](int i, int j) {
    if (is_void(i, j)) return bonds.clear_all(grid.layout().at(i, j));
    family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
      if (grid.contains(i + a, j + b) && is_void(i + a, j + b))
        bonds.clear(grid.layout().at(i, j), bit);
    });
  });
}

void cut_through(const Shape& shape, const NodeRange& range, const Grid& grid, const Family& family,
                 BondBits& bonds) {
  const Vec2 reach = Vec2::Constant(family.reach());
  for_nodes(range, [&](int i, int j) {
    const Vec2 here = grid.from_centre(i, j);
    if (may_cut(shape, {here - reach, here + reach}, tie))
      clear_at(i, j, grid, family, bonds,
               [&](const Segment& bond) { return cuts(shape, bond, tie); });
  });
}

void cut_around(const Outline& outline, const std::vector<std::uint8_t>& material, const Grid& grid,
                const Family& family, BondBits& bonds) {
  for_nodes(grid, [&](int i, int j) {
    if (material[grid.index(i, j)] == void_node) return;
    clear_at(i, j, grid, family, bonds,
             [&](const Segment& bond) { return leaves(outline, bond, tie); });
  });
}

}  // namespace

void carve(const Plate& plate, const std::vector<std::uint8_t>& material, const Grid& grid,
           const Family& family, BondBits& bonds) {
  for (const Cutout& cutout : plate.cutouts) {
    const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
    const NodeRange range = nodes_near(bounds(shape), grid, family.reach());
    clear_void(range, material, grid, family, bonds);
    if (cutout.bonds == Bridging::cut) cut_through(shape, range, grid, family, bonds);
  }
  for (const Outline& outline : plate.outlines) {
    clear_void({0, grid.nx - 1, 0, grid.ny - 1}, material, grid, family, bonds);
    cut_around(transformed(outline, grid.centre, 1.0 / grid.dx), material, grid, family, bonds);
  }
}

}  // namespace hackle
