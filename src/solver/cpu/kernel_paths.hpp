// SPDX-License-Identifier: MIT
// Chooses the path of the tiles of a row. Part of a kernel, see kernel_advance.cpp.
#pragma once

#include "solver/cpu/kernel_bond.hpp"
#include "solver/cpu/scratch.hpp"

namespace hackle::HACKLE_INSTRUCTION_SET {
namespace {

template <class Real, KernelFeatures features>
class PathChooser {
 public:
  // For a block of columns that begins at column `first` of the layout, counted from its first.
  PathChooser(const KernelData<Real>& data, Scratch<Real>& scratch, int first)
      : data_(data), scratch_(scratch), first_(first / NodeLayout::group) {}

  // Fills the runs of the scratch for the columns [begin, end) of the block. Must be called for the
  // rows of tiles in ascending order.
  void choose(int tile_row, int begin, int end) {
    look_ahead(tile_row, begin, end);
    TileRun* run = scratch_.runs.data() - 1;
    for (int q = begin; q < end; q = end_of_group(q)) {
      const int group = q >> 4, next = end_of_group(q);
      const bool linear = outlook(tile_row, group).linear;
      const Path path = cheapest(tile_row, group);
      if (q == begin || path != run->path || linear != run->linear) *++run = {path, linear, q, q};
      run->end = next < end ? next : end;
    }
    scratch_.run_count = static_cast<int>(run - scratch_.runs.data()) + 1;
    scratch_.computes = false;
    for (; run >= scratch_.runs.data(); --run)
      scratch_.computes |= run->path != Path::still && run->path != Path::linear;
  }

  // Counts the tiles of the row by path, in a block of `columns` columns.
  void count(int columns) {
    for (int n = 0; n < scratch_.run_count; ++n) {
      const TileRun& run = scratch_.runs[n];
      const int begin = run.begin > 0 ? run.begin : 0, end = run.end < columns ? run.end : columns;
      const auto path = static_cast<int>(run.linear ? Path::linear : run.path);
      if (begin < end) scratch_.counts[path] += (end - begin) / NodeLayout::group;
    }
  }

 private:
  static int end_of_group(int q) { return (q + NodeLayout::group) & -NodeLayout::group; }
  Outlook<Real>& outlook(int tile_row, int group) {
    return scratch_.outlooks[static_cast<unsigned>(tile_row + 3) % 3][group + 2];
  }

  // Finds the outlooks that this row of tiles needs and the previous row did not.
  void look_ahead(int tile_row, int begin, int end) {
    const bool linear = data_.linear_range > 0;
    const int first = !linear ? tile_row : fresh_ ? tile_row - 1 : tile_row + 1;
    for (int row = first; row <= (linear ? tile_row + 1 : tile_row); ++row)
      for (int group = (begin >> 4) - 1; group * NodeLayout::group < end + NodeLayout::group;
           ++group)
        outlook(row, group) = look(row, first_ + group);
    fresh_ = false;
  }

  Outlook<Real> look(int tile_row, int column) const;
  Path cheapest(int tile_row, int group);

  const KernelData<Real>& data_;
  Scratch<Real>& scratch_;
  int first_;          // tile
  bool fresh_ = true;  // no row chosen yet
};

template <class Real, KernelFeatures features>
Outlook<Real> PathChooser<Real, features>::look(int tile_row, int column) const {
  const TileGrid& tiles = data_.tiles;
  if (tile_row < 0 || tile_row >= tiles.rows || column < 0 || column >= tiles.columns) return {};
  const auto raise = [](Real& most, Real to) { most = to > most ? to : most; };
  Real direct = 0, xy = 0, yx = 0;
  Real heat = 0;
  Real threshold = features.varied ? unstretched<Real> : data_.min_threshold;
  std::uint32_t moving = data_.loaded[tiles.index(tile_row, column)];
  for (int r = tile_row > 0 ? tile_row - 1 : 0; r <= tile_row + 1 && r < tiles.rows; ++r)
    for (int c = column > 0 ? column - 1 : 0; c <= column + 1 && c < tiles.columns; ++c) {
      const TileRange<Real>& range = data_.range[tiles.index(r, c)];
      raise(direct, range.direct);
      raise(xy, range.xy);
      raise(yx, range.yx);
      moving |= range.moving;
      if constexpr (features.heated) raise(heat, data_.tile_heat[tiles.index(r, c)]);
      if (features.varied && range.min_threshold < threshold) threshold = range.min_threshold;
    }
  // The slack covers the rounding of the differences.
  constexpr auto slack = static_cast<Real>(1.00001);
  const Real strain = data_.bound.direct * direct + data_.bound.shear * (xy + yx);
  const Real squares = data_.bound.squares * (2 * direct * direct + xy * xy + yx * yx);
  Real bound = slack * (2 * strain + squares);
  if constexpr (features.heated) {
    bound += slack * 2 * heat;
    moving |= heat != 0;
  }
  const bool complete = data_.complete[tiles.index(tile_row, column)] != 0;
  return {bound, threshold, moving == 0, complete && moving != 0 && bound < data_.linear_range};
}

// Chooses the cheapest path with the same bits as the careful one. Bonds are not computed if all
// forces in and around the tile are linearised: nothing else reads their sums
// (src/solver/README.md 4.4).
template <class Real, KernelFeatures features>
Path PathChooser<Real, features>::cheapest(int tile_row, int group) {
  const Outlook<Real>& own = outlook(tile_row, group);
  if (own.still) return Path::still;
  if (own.linear) {
    bool deep = true;
    for (int row = tile_row - 1; row <= tile_row + 1; ++row)
      for (int g = group - 1; g <= group + 1; ++g) deep = deep && outlook(row, g).linear;
    if (deep) return Path::linear;
  }
  if (!(own.bound < own.threshold && own.bound < series_range<Real>)) return Path::careful;
  const int tile = data_.tiles.index(tile_row, first_ + group);
  return data_.intact[tile] != 0 ? Path::intact : Path::damaged;
}

}  // namespace
}  // namespace hackle::HACKLE_INSTRUCTION_SET
