// SPDX-License-Identifier: MIT
// A plate in slabs of rows, one for each rank: a rank takes the nodes of its own rows through
// steps. Between runs every rank has the whole plate.
#pragma once

#include <span>
#include <vector>

#include "base/ranks/ranks.hpp"

namespace hackle {

// Rows of another rank, or for it.
struct RowsOfRank {
  int rank = 0;
  int begin = 0;
  int end = 0;
};

struct Slab {
  Ranks* ranks = nullptr;   // nullptr: this process has the whole plate
  std::vector<int> begins;  // first row of every rank, then the end of the last; empty if alone

  bool is_whole() const { return ranks == nullptr; }
  int begin() const { return is_whole() ? 0 : begins[static_cast<std::size_t>(ranks->rank())]; }
  int end(int rows) const {
    return is_whole() ? rows : begins[static_cast<std::size_t>(ranks->rank()) + 1];
  }
  bool owns(int row) const { return is_whole() || (row >= begin() && row < end(0)); }
};

inline const Slab undivided{};

// Shares rows of tiles out, which begin at `first_rows` and end at the last of these: as many to
// every rank, to within one. Throws Error (refused) if there are more ranks than rows of tiles.
Slab share_out_slabs(Ranks* ranks, const std::vector<int>& first_rows);

// The slabs that would have taken the ranks equally long, where they took these `seconds`: whatever
// a row of tiles costs within a slab. Every rank keeps a row of tiles.
std::vector<int> slabs_of_equal_cost(const Slab& slab, const std::vector<int>& first_rows,
                                     std::span<const double> seconds);

// The rows of others that a rank needs, which reach by `below` and `above` beyond its own, and the
// rows of its own that others need. `begins` is that of a slab, in rows of any kind.
std::vector<RowsOfRank> rows_to_receive(std::span<const int> begins, int rank, int below,
                                        int above);
std::vector<RowsOfRank> rows_to_send(std::span<const int> begins, int rank, int below, int above);

// A sum over nodes, which are given row by row, upwards: rows are summed first, so that the bits do
// not depend on who has which (src/solver/README.md 6.3).
class RowSum {
 public:
  // On top of `start`.
  explicit RowSum(const Slab& slab, double start = 0.0) : slab_(slab), total_(start) {}

  // Only for rows of the slab.
  void add(int row, double term) {
    if (row != row_) end_row();
    row_ = row;
    sum_ += term;
  }
  // Of all ranks, each of which asks.
  double value();

 private:
  void end_row();

  const Slab& slab_;
  double total_;
  int row_ = -1;
  double sum_ = 0.0;
  std::vector<double> of_rows_;
};

// Completes a list with a value of each row on all ranks, which know those of their own.
void complete_rows(const Slab& slab, std::span<double> of_row);

}  // namespace hackle
