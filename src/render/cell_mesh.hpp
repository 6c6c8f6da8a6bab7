// SPDX-License-Identifier: MIT
// Cells of a displaced lattice as quadrilaterals. Cells that hang together share their corners;
// where the bonds between neighbours are broken, the plate opens.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "measure/links.hpp"
#include "render/camera.hpp"

namespace hackle {

// Cells are taken together in blocks of `size` x `size`, counted from the lower left corner of the
// window.
struct Blocks {
  int size = 1;
  int columns = 0, rows = 0;

  std::size_t count() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

// The largest blocks that are at most a pixel when `seen` has so many px; they cover `window`.
Blocks blocks_of(const Window& window, const Window& seen, int width, int height);

// A displaced lattice; each span by Grid::index.
struct Displaced {
  std::span<const float> displacement;  // m, x and y of each node; empty where nothing is displaced
  std::span<const std::uint8_t> links;  // of Link
  double magnification = 1.0;           // of the displacement
};

// What may be seen of the lattice in the window, turned by `rotation`, rad: where cells come from
// that are displaced into it.
Window seen_cells(const Window& window, double rotation, const Grid& grid,
                  const Displaced& displaced);

// The corners of every block, Camera::share of each: lower left, lower right, upper left, upper
// right; 8 numbers a block, block by block. A corner of the lattice is moved by the mean of the
// nodes around it that hang together by bonds between them. Blocks beyond the lattice have no size.
std::vector<float> corners(const Blocks& blocks, const Window& window, const Grid& grid,
                           const Displaced& displaced, const Camera& camera);

}  // namespace hackle
