// SPDX-License-Identifier: MIT
#include "measure/gaps.hpp"

#include <algorithm>

#include "lattice/carve.hpp"
#include "measure/field.hpp"

namespace hackle {
namespace {

// Returns the bonds of the plate without its cracks.
BondBits uncracked(const Plate& plate, const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  BondBits bonds(grid.layout(), lattice.family.words());
  lattice.family.for_each_bond([&](int column, int row, const Vec2&, double, int bit) {
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        if (grid.contains(i + column, j + row)) bonds.set(grid.layout().at(i, j), bit);
  });
  carve(plate, lattice.material, grid, lattice.family, bonds);
  return bonds;
}

}  // namespace

std::vector<float> gaps(const View& view) {
  const std::vector<Crack>& cracks = view.plate().cracks;
  if (std::ranges::find(cracks, Born::absent, &Crack::born) == cracks.end())
    return damage(view).values;
  const Lattice& lattice = view.lattice();
  const auto whole = degrees(lattice.grid, lattice.family, uncracked(view.plate(), lattice));
  const auto left = degrees(lattice.grid, lattice.family, view.state().bonds);
  std::vector<float> shares(whole.size());
  for (std::size_t node = 0; node < shares.size(); ++node)
    if (whole[node] > 0)
      shares[node] = static_cast<float>(whole[node] - left[node]) / static_cast<float>(whole[node]);
  return shares;
}

}  // namespace hackle
