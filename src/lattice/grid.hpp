// SPDX-License-Identifier: MIT
// The square lattice of a plate.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lattice/node_layout.hpp"
#include "scene/plate.hpp"

namespace hackle {

// Takes the place of a material index for nodes that cut-outs removed.
inline constexpr std::uint8_t void_node = 255;

// nx columns and ny rows of nodes, each at the centre of a cell of dx by dx. The lattice is centred
// on the plate. Nodes are numbered row by row from the lower left: index = j * nx + i.
struct Grid {
  int nx = 0;
  int ny = 0;
  double dx = 0.0;    // m
  Vec2 centre{0, 0};  // m, of the plate

  std::size_t nodes() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  NodeLayout layout() const { return {nx, ny}; }
  bool contains(int i, int j) const { return i >= 0 && i < nx && j >= 0 && j < ny; }

  // Returns the position of a node relative to the centre of the lattice, in units of dx. Multiples
  // of 1/2 are exact, and exactly opposite for mirror images, so decisions based on it are
  // mirror-symmetric.
  Vec2 from_centre(int i, int j) const { return {0.5 * (2 * i + 1 - nx), 0.5 * (2 * j + 1 - ny)}; }
  // Returns the same for a point of the plate given in m.
  Vec2 from_centre(const Vec2& point) const { return (point - centre) / dx; }
  // Returns the position of a node, m.
  Vec2 position(int i, int j) const { return centre + dx * from_centre(i, j); }
};

// Makes the lattice with spacing `dx` whose size is nearest to the plate's: width and height are
// rounded to whole cells.
Grid make_grid(const Plate& plate, double dx);

}  // namespace hackle
