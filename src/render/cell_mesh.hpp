// SPDX-License-Identifier: MIT
// Cells of a displaced lattice as quadrilaterals. Cells joined by bonds share their corners; where
// the bonds between neighbours are broken, the plate opens.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "measure/links.hpp"
#include "render/camera.hpp"

namespace hackle {

// Cells grouped in blocks of `size` x `size`, counted from the lower left corner of the window.
struct Blocks {
  int size = 1;
  int columns = 0, rows = 0;

  std::size_t count() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

// Returns the largest blocks that cover at most a pixel if `seen` has this many px; they cover
// `window`.
Blocks blocks_of(const Window& window, const Window& seen, int width, int height);

// A displaced lattice; each span is indexed by Grid::index.
struct Displaced {
  std::span<const float> displacement;  // m, x and y per node; empty without displacement
  std::span<const std::uint8_t> links;  // of Link
  double magnification = 1.0;           // factor on the displacement
};

// The four nodes around a corner of the lattice: lower left, lower right, upper left, upper right.
inline constexpr int around = 4;
// Returns, for each node around the corner between columns i - 1 and i and rows j - 1 and j, bits
// of those among the four that it is joined to, itself included. Nodes beyond the lattice are
// joined to none.
std::array<unsigned, around> joined_around(const Grid& grid, std::span<const std::uint8_t> links,
                                           int i, int j);

// Returns the cells that may be visible in the window, turned by `rotation` (rad): displacements
// may move outside cells into it.
Window seen_cells(const Window& window, double rotation, const Grid& grid,
                  const Displaced& displaced);

// Returns the corners of every block as Camera::share: lower left, lower right, upper left, upper
// right; 8 numbers per block, block by block. A corner of the lattice moves by the mean of those
// surrounding nodes that are joined by bonds between them. Blocks beyond the lattice have no size.
std::vector<float> corners(const Blocks& blocks, const Window& window, const Grid& grid,
                           const Displaced& displaced, const Camera& camera);

}  // namespace hackle
