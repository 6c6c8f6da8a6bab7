// SPDX-License-Identifier: MIT
// Differences between neighbours, which bound the stretch of bonds. Part of a kernel, see
// kernel_advance.cpp.
#pragma once

#include "solver/cpu/kernel.hpp"
#include "solver/cpu/simd.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

template <class Real>
struct Differences {
  Vector<Real> direct{}, xy{}, yx{};

  // Adds differences between the places n and both their neighbours in the row: both, so that the
  // mirror image of a tile has the mirror images of its differences.
  HACKLE_INLINE void add_along_row(const Real* ux, const Real* uy) {
    const Vector<Real> x = load(ux), y = load(uy);
    direct = most<Real>(
        direct, most<Real>(magnitude<Real>(load(ux + 1) - x), magnitude<Real>(x - load(ux - 1))));
    yx = most<Real>(
        yx, most<Real>(magnitude<Real>(load(uy + 1) - y), magnitude<Real>(y - load(uy - 1))));
  }

  // Adds differences between the places n and those in the row above.
  HACKLE_INLINE void add_across_rows(const Real* ux, const Real* uy, std::ptrdiff_t stride) {
    direct = most<Real>(direct, magnitude<Real>(load(uy + stride) - load(uy)));
    xy = most<Real>(xy, magnitude<Real>(load(ux + stride) - load(ux)));
  }

  // Widens the range of the tile, without the columns outside the plate.
  HACKLE_INLINE void widen(TileRange<Real>& range, int column, int nx) const {
    for (int lane = 0; lane < lanes<Real>; ++lane) {
      if (column + lane < 0 || column + lane >= nx) continue;
      range.direct = direct[lane] > range.direct ? direct[lane] : range.direct;
      range.xy = xy[lane] > range.xy ? xy[lane] : range.xy;
      range.yx = yx[lane] > range.yx ? yx[lane] : range.yx;
    }
  }
};

// Columns beside the plate copy its edge, so there is no difference.
template <class Real>
HACKLE_INLINE void extend_edges(Real* u, const NodeLayout& layout, int j) {
  u[layout.at(-1, j)] = u[layout.at(0, j)];
  u[layout.at(layout.nx, j)] = u[layout.at(layout.nx - 1, j)];
}

template <class Real>
HACKLE_INLINE void survey_tile(const KernelData<Real>& data, int tile_row, int group, Rows rows) {
  const TileGrid& tiles = data.tiles;
  TileRange<Real>& range = data.next_range[tiles.index(tile_row, group)];
  range.direct = range.xy = range.yx = 0;
  const int first = tiles.first_row[tile_row], end = tiles.first_row[tile_row + 1];
  for (int part = 0; part < NodeLayout::group; part += lanes<Real>) {
    const int column = data.layout.first_column() + group * NodeLayout::group + part;
    Differences<Real> differences;
    for (int j = first; j < end; ++j) {
      const std::ptrdiff_t at = data.layout.at(column, j);
      differences.add_along_row(data.next_ux + at, data.next_uy + at);
      if (j + 1 < rows.end)
        differences.add_across_rows(data.next_ux + at, data.next_uy + at, data.layout.stride());
    }
    if (first > rows.begin) {
      const std::ptrdiff_t below = data.layout.at(column, first - 1);
      differences.add_across_rows(data.next_ux + below, data.next_uy + below, data.layout.stride());
    }
    differences.widen(range, column, data.layout.nx);
  }
}

template <class Real>
void survey_rows(const KernelData<Real>& data, Rows rows) {
  for (int j = rows.begin; j < rows.end; ++j) {
    extend_edges(data.next_ux, data.layout, j);
    extend_edges(data.next_uy, data.layout, j);
  }
  for (int tile_row = 0; tile_row < data.tiles.rows; ++tile_row) {
    const int first = data.tiles.first_row[tile_row];
    if (first < rows.begin || first >= rows.end) continue;
    for (int group = 0; group < data.tiles.columns; ++group)
      survey_tile(data, tile_row, group, rows);
  }
}

template <class Real>
void join_rows(const KernelData<Real>& data, int j) {
  int tile_row = 0;
  while (data.tiles.first_row[tile_row] < j) ++tile_row;
  for (int group = 0; group < data.tiles.columns; ++group)
    for (int part = 0; part < NodeLayout::group; part += lanes<Real>) {
      const int column = data.layout.first_column() + group * NodeLayout::group + part;
      const std::ptrdiff_t below = data.layout.at(column, j - 1);
      Differences<Real> differences;
      differences.add_across_rows(data.next_ux + below, data.next_uy + below, data.layout.stride());
      differences.widen(data.next_range[data.tiles.index(tile_row - 1, group)], column,
                        data.layout.nx);
      differences.widen(data.next_range[data.tiles.index(tile_row, group)], column, data.layout.nx);
    }
}

}  // namespace
}  // namespace hackle::HACKLE_INSTRUCTION_SET
