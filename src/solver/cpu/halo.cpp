// SPDX-License-Identifier: MIT
#include "solver/cpu/halo.hpp"

#include <algorithm>

namespace hackle {
namespace {

// The paths of a row of tiles follow from the bounds of the rows beside it, and these from the
// ranges of the next. A sweep begins with the row of tiles below its own.
constexpr int tiles_below = 3, tiles_above = 2;

}  // namespace

template <class Real>
Halo<Real>::Halo(const Slab& slab, const NodeLayout& layout, int reach,
                 const std::vector<int>& first_rows)
    : slab_(slab), layout_(layout) {
  if (slab.is_whole()) return;
  for (const int row : slab.begins)
    tile_begins_.push_back(
        static_cast<int>(std::ranges::find(first_rows, row) - first_rows.begin()));
  const int rank = slab.ranks->rank();
  sent_ = rows_to_send(slab.begins, rank, reach, reach);
  received_ = rows_to_receive(slab.begins, rank, reach, reach);
  sent_tiles_ = rows_to_send(tile_begins_, rank, tiles_below, tiles_above);
  received_tiles_ = rows_to_receive(tile_begins_, rank, tiles_below, tiles_above);
}

template <class Real>
bool Halo<Real>::is_needed(int begin, int end) const {
  return std::ranges::any_of(
      sent_, [&](const RowsOfRank& rows) { return rows.begin < end && begin < rows.end; });
}

template <class Real>
template <class T>
void Halo<Real>::exchange_rows(T* values, std::ptrdiff_t row, const std::vector<RowsOfRank>& sent,
                               const std::vector<RowsOfRank>& received) {
  const auto bytes = [&](const RowsOfRank& rows) {
    return std::span(values + rows.begin * row,
                     static_cast<std::size_t>((rows.end - rows.begin) * row));
  };
  for (const RowsOfRank& rows : sent) outgoing_.push_back({rows.rank, std::as_bytes(bytes(rows))});
  for (const RowsOfRank& rows : received)
    incoming_.push_back({rows.rank, std::as_writable_bytes(bytes(rows))});
}

template <class Real>
void Halo<Real>::begin(std::initializer_list<Values<Real>*> arrays) {
  outgoing_.clear();
  incoming_.clear();
  for (Values<Real>* array : arrays)
    if (!array->empty())
      exchange_rows(array->data() + NodeLayout::group, layout_.stride(), sent_, received_);
  slab_.ranks->begin_exchange(outgoing_, incoming_);
}

template <class Real>
void Halo<Real>::exchange(std::vector<TileRange<Real>>& ranges) {
  outgoing_.clear();
  incoming_.clear();
  exchange_rows(ranges.data(), layout_.groups(), sent_tiles_, received_tiles_);
  slab_.ranks->begin_exchange(outgoing_, incoming_);
  slab_.ranks->end_exchange();
}

template <class Real>
std::vector<BrokenBond> Halo<Real>::all_of(const std::vector<BrokenBond>& broken_bonds) const {
  return slab_.ranks->gather(bytes_to_send(broken_bonds)).template as<BrokenBond>();
}

template <class Real>
void Halo<Real>::complete(Values<Real>& values) const {
  if (values.empty()) return;
  const std::span rows = std::span(values).subspan(NodeLayout::group);
  slab_.ranks->complete(std::as_writable_bytes(rows),
                        static_cast<std::size_t>(layout_.stride()) * sizeof(Real), slab_.begins);
}

template <class Real>
void Halo<Real>::complete(std::vector<TileRange<Real>>& ranges) const {
  slab_.ranks->complete(std::as_writable_bytes(std::span(ranges)),
                        static_cast<std::size_t>(layout_.groups()) * sizeof(TileRange<Real>),
                        tile_begins_);
}

template class Halo<float>;
template class Halo<double>;

}  // namespace hackle
