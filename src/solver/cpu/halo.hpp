// SPDX-License-Identifier: MIT
// What the ranks of a plate tell each other in a step (src/solver/README.md 10.2): rows of nodes
// within reach of a slab, the ranges of tiles around it, and the bonds that broke.
#pragma once

#include <vector>

#include "lattice/node_layout.hpp"
#include "solver/broken_bond.hpp"
#include "solver/cpu/tiles.hpp"
#include "solver/slab.hpp"
#include "solver/values.hpp"

namespace hackle {

template <class Real>
class Halo {
 public:
  // `first_rows` is that of tile_rows().
  Halo(const Slab& slab, const NodeLayout& layout, int reach, const std::vector<int>& first_rows);

  // Whether others need rows from `begin` to `end` of this rank.
  bool is_needed(int begin, int end) const;

  // Sends rows of these arrays and receives those of others until end().
  void begin(std::initializer_list<Values<Real>*> arrays);
  void end() { slab_.ranks->end_exchange(); }
  // Exchanges rows of tiles.
  void exchange(std::vector<TileRange<Real>>& ranges);
  // Returns the bonds that broke on all ranks, in their order.
  std::vector<BrokenBond> all_of(const std::vector<BrokenBond>& broken_bonds) const;
  // Completes an array of nodes, or of tiles, on all ranks.
  void complete(Values<Real>& values) const;
  void complete(std::vector<TileRange<Real>>& ranges) const;

 private:
  template <class T>
  void exchange_rows(T* values, std::ptrdiff_t row, const std::vector<RowsOfRank>& sent,
                     const std::vector<RowsOfRank>& received);

  Slab slab_;
  NodeLayout layout_;
  std::vector<int> tile_begins_;  // as Slab::begins, in rows of tiles
  std::vector<RowsOfRank> sent_, received_, sent_tiles_, received_tiles_;
  std::vector<Outgoing> outgoing_;
  std::vector<Incoming> incoming_;
};

extern template class Halo<float>;
extern template class Halo<double>;

}  // namespace hackle
