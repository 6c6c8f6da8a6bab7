// SPDX-License-Identifier: MIT
// Shapes on the lattice: the nodes they cover, and the nodes and bonds they remove.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/interrupt.hpp"
#include "lattice/bonds.hpp"
#include "lattice/family.hpp"
#include "lattice/grid.hpp"

namespace hackle {

// Distances below this count as 0, in units of dx.
inline constexpr double tie = 1e-9;

// The nodes in a box, which may extend beyond the lattice: columns first_i to last_i, rows
// likewise.
struct NodeRange {
  int first_i, last_i, first_j, last_j;

  std::size_t columns() const {
    return static_cast<std::size_t>(std::max(0, last_i - first_i + 1));
  }
  std::size_t rows() const { return static_cast<std::size_t>(std::max(0, last_j - first_j + 1)); }
  std::size_t count() const { return columns() * rows(); }
  // Returns the index of a node in the range, row by row from the lower left.
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j - first_j) * columns() +
           static_cast<std::size_t>(i - first_i);
  }
};
// Returns the range of all nodes closer to the box than `margin` spacings. The box is in lattice
// units, relative to the centre of the lattice.
NodeRange nodes_near(const Box& box, const Grid& grid, int margin);
// Returns a range that contains all nodes of a region.
NodeRange nodes_of(const Region& region, const Grid& grid);

// Calls work(i, j) row by row. All loops that set up a plate use it, so that Ctrl-C ends them
// between two rows. Throws Error (interrupted).
template <class Work>
void for_nodes(const NodeRange& range, const Work& work) {
  for (int j = range.first_j; j <= range.last_j; ++j) {
    throw_if_interrupted();
    for (int i = range.first_i; i <= range.last_i; ++i) work(i, j);
  }
}
template <class Work>
void for_nodes(const Grid& grid, const Work& work) {
  for_nodes(NodeRange{0, grid.nx - 1, 0, grid.ny - 1}, work);
}

// Calls work(i, j) for every node that the shape (in m) covers, rim included.
template <class Work>
void for_nodes_in(const Shape& shape, const Grid& grid, const Work& work) {
  const Shape scaled = transformed(shape, grid.centre, 1.0 / grid.dx);
  for_nodes(nodes_near(bounds(scaled), grid, 1), [&](int i, int j) {
    if (covers(scaled, grid.from_centre(i, j), tie)) work(i, j);
  });
}
// Without a region, calls work(i, j) for every node.
template <class Work>
void for_nodes_in(const Region& region, const Grid& grid, const Work& work) {
  if (region) return for_nodes_in(*region, grid, work);
  for_nodes(grid, work);
}

// Returns the plate's own material, then those of its inclusions, each once.
std::vector<Material> distinct_materials(const Plate& plate);

// Returns one value per node: the index in distinct_materials of the last inclusion that covers it
// (rim included), or Lattice::void_node inside a cut-out or outside an outline (a node on a rim
// stays). Empty without inclusions, cut-outs and outlines. Throws Error (refused) if no node is
// left.
std::vector<std::uint8_t> materials_of_nodes(const Plate& plate, const Grid& grid);

// Clears the bonds of void nodes, those that pass through the inside of a cut-out that cuts them,
// and those that leave an outline.
void carve(const Plate& plate, const std::vector<std::uint8_t>& material, const Grid& grid,
           const Family& family, BondBits& bonds);

}  // namespace hackle
