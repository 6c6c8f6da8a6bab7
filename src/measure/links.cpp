// SPDX-License-Identifier: MIT
#include "measure/links.hpp"

#include <cstdlib>

namespace hackle {
namespace {

std::uint8_t link_to(int column, int row) {
  if (row == 0) return Link::right;
  return column > 0 ? Link::above_right : column == 0 ? Link::above : Link::above_left;
}

}  // namespace

std::vector<std::uint8_t> links(const View& view) {
  const Lattice& lattice = view.lattice();
  const Grid& grid = lattice.grid;
  const BondBits& bonds = view.state().bonds;
  const NodeLayout layout = grid.layout();
  std::vector<std::uint8_t> all(grid.nodes());
  lattice.family.for_each_bond([&](int column, int row, const Vec2&, double, int bit) {
    if (std::abs(column) > 1 || row > 1) return;
    const std::uint8_t link = link_to(column, row);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        if (bonds.holds(layout.at(i, j), bit)) all[grid.index(i, j)] |= link;
  });
  return all;
}

}  // namespace hackle
