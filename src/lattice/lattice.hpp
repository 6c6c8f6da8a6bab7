// SPDX-License-Identifier: MIT
// The scene on a square lattice: everything that does not change while it is solved.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/bonds.hpp"
#include "lattice/calibration.hpp"
#include "lattice/family.hpp"
#include "lattice/grid.hpp"

namespace hackle {

// A node on which a load acts.
struct LoadedNode {
  int i = 0;
  int j = 0;
  Vec2 acceleration{0, 0};  // m/s2
};

struct Lattice {
  Lattice(const Plate& plate, const Numerics& numerics);

  Grid grid;
  Family family;
  Calibration calibration;
  double rho;                       // kg/m3
  double step_limit;                // s, 2/omega_max
  BondBits bonds;                   // at t = 0, after the cracks were cut
  std::vector<std::uint16_t> born;  // per node: bonds it was born with, the base of its damage
  BondBits unbreakable;             // bonds of no-fail zones; empty when there are none
  std::vector<float> strength;      // per node: its critical stretch over s0; empty when all are 1
  std::vector<LoadedNode> loads;    // each node once, ordered by index

  std::int64_t bonds_born() const;
};

// Bonds that each node has among `bonds`, in the order of Grid::index.
std::vector<std::uint16_t> degrees(const Grid& grid, const Family& family, const BondBits& bonds);

// Whether the bond of node (i, j) to (i + column, j + row) holds; false when there is none.
bool holds(const Grid& grid, const Family& family, const BondBits& bonds, int i, int j, int column,
           int row);

// Breaks all bonds of a node.
void isolate(const Grid& grid, const Family& family, int i, int j, BondBits& bonds);

}  // namespace hackle
