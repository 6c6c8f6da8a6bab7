// SPDX-License-Identifier: MIT
#include "lattice/carve.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/lattice.hpp"

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

std::vector<std::uint8_t> materials_of_nodes(const Plate& plate, const Grid& grid) {
  if (plate.cutouts.empty() && plate.inclusions.empty()) return {};
  std::vector<std::uint8_t> material(grid.nodes());
  std::uint8_t kind = 0;
  for (const Inclusion& inclusion : plate.inclusions) {
    ++kind;
    for_nodes_in(inclusion.shape, grid, [&](int i, int j) { material[grid.index(i, j)] = kind; });
  }
  for (const Cutout& cutout : plate.cutouts) {
    const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
    const NodeRange range = nodes_near(bounds(shape), grid, 1);
    for (int j = range.first_j; j <= range.last_j; ++j)
      for (int i = range.first_i; i <= range.last_i; ++i)
        if (is_inside(shape, grid.from_centre(i, j), tie))
          material[grid.index(i, j)] = Lattice::void_node;
  }
  return material;
}

void carve(const std::vector<Cutout>& cutouts, const std::vector<std::uint8_t>& material,
           const Grid& grid, const Family& family, BondBits& bonds) {
  for (const Cutout& cutout : cutouts) {
    const Shape shape = transformed(cutout.shape, grid.centre, 1.0 / grid.dx);
    const NodeRange range = nodes_near(bounds(shape), grid, family.reach());
    for (int j = range.first_j; j <= range.last_j; ++j)
      for (int i = range.first_i; i <= range.last_i; ++i)
        family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
          if (!grid.contains(i + a, j + b)) return;
          const bool ends_void = material[grid.index(i, j)] == Lattice::void_node ||
                                 material[grid.index(i + a, j + b)] == Lattice::void_node;
          const Segment bond{grid.from_centre(i, j), grid.from_centre(i + a, j + b)};
          if (ends_void || cuts(shape, bond, tie)) bonds.clear(grid.layout().at(i, j), bit);
        });
  }
}

}  // namespace hackle
