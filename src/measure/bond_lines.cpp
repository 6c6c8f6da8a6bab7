// SPDX-License-Identifier: MIT
#include "measure/bond_lines.hpp"

#include <algorithm>

namespace hackle {

std::vector<BondLine> bond_lines(const View& view, const NodeBlock& block) {
  const Lattice& lattice = view.lattice();
  const Grid& grid = lattice.grid;
  const NodeLayout layout = grid.layout();
  std::vector<BondLine> lines;
  lattice.family.for_each_bond([&](int column, int row, const Vec2&, double, int bit) {
    for (int j = std::max(block.bottom, 0); j <= std::min(block.top, grid.ny - 1); ++j)
      for (int i = std::max(block.left, 0); i <= std::min(block.right, grid.nx - 1); ++i)
        if (lattice.bonds.holds(layout.at(i, j), bit))
          lines.push_back({i, j, column, row, view.state().bonds.holds(layout.at(i, j), bit)});
  });
  std::stable_partition(lines.begin(), lines.end(),
                        [](const BondLine& bond) { return bond.holds; });
  return lines;
}

}  // namespace hackle
