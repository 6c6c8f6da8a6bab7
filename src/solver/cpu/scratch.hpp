// SPDX-License-Identifier: MIT
// Scratch memory of one thread for a sweep. The plate is swept in blocks of columns narrow enough
// to keep all of it in the fastest cache.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "solver/cpu/kernel.hpp"
#include "solver/values.hpp"

namespace hackle {

// Rows of values over the columns of a block and one group of columns on either side. Column 0 is
// the first of the block.
template <class Real>
class ScratchRows {
 public:
  ScratchRows(int rows, int columns)
      : stride_(columns + 4 * NodeLayout::group),
        values_(static_cast<std::size_t>(rows * stride_)) {}

  Real* row(int k) { return values_.data() + k * stride_ + 2 * NodeLayout::group; }
  void clear() { std::ranges::fill(values_, Real{}); }

 private:
  std::ptrdiff_t stride_;
  Values<Real> values_;
};

// Neighbouring columns of a row with the same path.
struct TileRun {
  Path path = Path::still;  // of the bonds they keep
  bool linear = false;      // their own force is linearised
  int begin = 0;
  int end = 0;
};

// The bounds for bonds that begin or end in a tile.
template <class Real>
struct Outlook {
  Real bound{};      // of |e|
  Real threshold{};  // smallest e at which one may break
  bool still = true;
  bool linear = false;  // the forces on its nodes may be linearised
};

template <class Real>
struct Scratch {
  // The largest number of columns per block, a multiple of a group: rows of 4 kB, so that the dozen
  // rows in use at a time stay near the fastest cache, and few groups are summed twice.
  static constexpr int block = 4096 / sizeof(Real);

  Scratch(int widest, int reach, bool linear)
      : columns(std::min(block, widest)),
        up(3, columns),
        down(3 * (reach + 1), columns),
        bond(6, columns),
        seen(2, columns),
        folded(linear ? 4 * (reach + 1) : 0, columns),
        runs(static_cast<std::size_t>(columns) / NodeLayout::group + 2) {
    for (auto& row : outlooks)
      row.resize(static_cast<std::size_t>(columns) / NodeLayout::group + 4);
  }

  int columns;
  ScratchRows<Real> up;  // force x, y of the bonds that a row keeps, then of all; smallest e
  ScratchRows<Real>
      down;  // the same for bonds that lower rows keep: 3 (row mod (reach + 1)) + 0..2
  ScratchRows<Real> bond;    // force x, y and e of the images of one class: 3 image + 0..2
  ScratchRows<Real> seen;    // of a row of tiles: bits of u and v, smallest threshold
  ScratchRows<Real> folded;  // see kernel_linear.hpp
  // For three rows of tiles, row t in t mod 3, over the block and two tiles on either side.
  std::array<std::vector<Outlook<Real>>, 3> outlooks;
  std::vector<TileRun>
      runs;  // of a row of tiles, over the block and the columns that reach into it
  int run_count = 0;
  bool computes = false;  // some run computes bonds
  std::vector<BrokenBond> broken_bonds;
  PathCounts counts{};
};

}  // namespace hackle
