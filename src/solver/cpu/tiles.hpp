// SPDX-License-Identifier: MIT
// The plate in tiles: every step chooses for each the cheapest path that its state allows
// (src/solver/README.md 4.4).
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/node_layout.hpp"
#include "solver/path_counts.hpp"

namespace hackle {

// A tile is one group of columns of the layout by at least `reach` rows. Rows of tiles are mirror
// images of each other about the midline.
struct TileGrid {
  const int* first_row = nullptr;  // of every row of tiles, then the end of the last
  int rows = 0;
  int columns = 0;

  int index(int row, int column) const { return row * columns + column; }
  int count() const { return rows * columns; }
};

// Returns the first rows of the rows of tiles of a lattice with ny rows, and ny.
std::vector<int> tile_rows(int ny, int reach);

// Bounds on the stretch of bonds in a tile (src/solver/README.md 4.5): the largest differences of
// displacements between neighbouring nodes, including those across its border.
template <class Real>
struct TileRange {
  Real direct{};  // |d_x u_x|, |d_y u_y|
  Real xy{};      // |d_y u_x|
  Real yx{};      // |d_x u_y|
  Real min_threshold{};
  std::uint32_t moving = 0;  // some u or v is not 0
};

}  // namespace hackle
