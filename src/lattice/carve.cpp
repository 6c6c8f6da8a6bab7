// SPDX-License-Identifier: MIT
#include "lattice/carve.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace hackle {

NodeRange nodes_near(const Box& box, const Grid& grid, int margin) {
  const auto range = [margin](double least, double most, int n) {
    const double middle = 0.5 * (n - 1), last = n - 1;
    const double from = std::floor(std::clamp(least + middle, -1.0, last + 1.0)) - margin;
    const double to = std::ceil(std::clamp(most + middle, -1.0, last + 1.0)) + margin;
    return std::pair{static_cast<int>(std::max(from, 0.0)), static_cast<int>(std::min(to, last))};
  };
  const auto [first_i, last_i] = range(box.least.x(), box.most.x(), grid.nx);
  const auto [first_j, last_j] = range(box.least.y(), box.most.y(), grid.ny);
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
  if (plate.cutouts.empty() && plate.inclusions.empty()) return {};
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
  if (std::ranges::count(material, void_node) == static_cast<std::ptrdiff_t>(material.size()))
    throw Error(ErrorKind::refused, "plate: its cut-outs leave no node of it",
                "make them smaller, or the spacing finer");
  return material;
}

namespace {

// Removes bonds that node (i, j) keeps.
void carve_at(int i, int j, const Shape& shape, const std::vector<std::uint8_t>& material,
              const Grid& grid, const Family& family, BondBits& bonds) {
  const auto is_void = [&](int column, int row) {
    return material[grid.index(column, row)] == void_node;
  };
  if (is_void(i, j)) return bonds.clear_all(grid.layout().at(i, j));
  const Vec2 here = grid.from_centre(i, j), reach = Vec2::Constant(family.reach());
  const bool near = may_cut(shape, {here - reach, here + reach}, tie);
  family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    if (!grid.contains(i + a, j + b)) return;
    if (is_void(i + a, j + b) || (near && cuts(shape, {here, grid.from_centre(i + a, j + b)}, tie)))
      bonds.clear(grid.layout().at(i, j), bit);
  });
}

}  // namespace

void carve(const std::vector<Cutout>& cutouts, const std::vector<std::uint8_t>& material,
           const Grid& grid, const Family& family, BondBits& bonds) {
  for (const Cutout& cutout : cutouts) {
    const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
    for_nodes(nodes_near(bounds(shape), grid, family.reach()),
              [&](int i, int j) { carve_at(i, j, shape, material, grid, family, bonds); });
  }
}

}  // namespace hackle
