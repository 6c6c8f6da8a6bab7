// SPDX-License-Identifier: MIT
// The square lattice that a plate is cut into.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lattice/node_layout.hpp"
#include "scene/plate.hpp"

namespace hackle {

// Marks, among the materials of nodes, those that cut-outs removed.
inline constexpr std::uint8_t void_node = 255;

// nx columns and ny rows of nodes, each the centre of a cell of dx by dx. The lattice is centred on
// the plate. Nodes are numbered row by row from the lower left: index = j * nx + i.
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

  // Place of a node from the centre of the lattice, in units of dx. Multiples of 1/2, hence exact,
  // and exactly opposite for mirror images: decisions made on it are mirror-symmetric.
  Vec2 from_centre(int i, int j) const { return {0.5 * (2 * i + 1 - nx), 0.5 * (2 * j + 1 - ny)}; }
  // The same measure of a point of the plate given in m.
  Vec2 from_centre(const Vec2& point) const { return (point - centre) / dx; }
  // Place of a node, m.
  Vec2 position(int i, int j) const { return centre + dx * from_centre(i, j); }
};

// The lattice of spacing `dx` whose size is nearest to the plate's: width and height are rounded to
// whole cells.
Grid make_grid(const Plate& plate, double dx);

}  // namespace hackle
