// SPDX-License-Identifier: MIT
// A small lattice with prescribed displacements, for pictures.
#pragma once

#include <vector>

#include "render/cell_mesh.hpp"

namespace hackle::test {

inline constexpr std::uint8_t all_links =
    Link::right | Link::above_right | Link::above | Link::above_left;

// A lattice of cells of 1 m, shown at 1 px per cell; `u` is the displacement of node (i, j).
struct DisplacedLattice {
  explicit DisplacedLattice(int nx, int ny)
      : grid{nx, ny, 1.0, {0.5 * nx, 0.5 * ny}},
        window{0, 0, nx, ny},
        u(2 * grid.nodes()),
        links(grid.nodes(), all_links) {}

  std::vector<float> corners_of(const Blocks& blocks, double magnification = 1.0) const {
    const Camera camera(grid, window, 0.0, {0, 0, grid.nx, grid.ny});
    return corners(blocks, window, grid, {u, links, magnification}, camera);
  }

  Grid grid;
  Window window;
  std::vector<float> u;
  std::vector<std::uint8_t> links;
};

}  // namespace hackle::test
