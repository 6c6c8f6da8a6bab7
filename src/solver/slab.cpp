// SPDX-License-Identifier: MIT
#include "solver/slab.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {

Slab share_out_slabs(Ranks* ranks, const std::vector<int>& first_rows) {
  if (ranks == nullptr || ranks->count() == 1) return {};
  const auto rows = static_cast<int>(first_rows.size()) - 1;
  if (ranks->count() > rows)
    throw Error(
        ErrorKind::refused,
        fmt::format("simulate: {} ranks are more than this plate of {} rows of nodes serves",
                    ranks->count(), first_rows.back()),
        rows == 1 ? "start it alone" : fmt::format("take at most {} ranks", rows));
  Slab slab{ranks, {}};
  for (int rank = 0; rank <= ranks->count(); ++rank)
    slab.begins.push_back(
        first_rows[static_cast<std::size_t>(std::int64_t{rows} * rank / ranks->count())]);
  return slab;
}

std::vector<int> slabs_of_equal_cost(const Slab& slab, const std::vector<int>& first_rows,
                                     std::span<const double> seconds) {
  const auto rows = first_rows.size() - 1, ranks = seconds.size();
  std::vector<double> cost(rows + 1);  // of all rows of tiles below
  std::size_t rank = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    while (first_rows[row] >= slab.begins[rank + 1]) ++rank;
    const double height = first_rows[row + 1] - first_rows[row];
    cost[row + 1] =
        cost[row] + seconds[rank] * height / (slab.begins[rank + 1] - slab.begins[rank]);
  }
  std::vector<int> begins{0};
  std::size_t row = 0;
  for (std::size_t next = 1; next < ranks; ++next) {
    const double share = cost.back() * static_cast<double>(next) / static_cast<double>(ranks);
    ++row;
    while (row < rows - (ranks - next) && cost[row + 1] - share < share - cost[row]) ++row;
    begins.push_back(first_rows[row]);
  }
  begins.push_back(first_rows.back());
  return begins;
}

namespace {

// The rows of one rank that another needs, on one side of it.
void add_common(std::vector<RowsOfRank>& list, int named, std::pair<int, int> rows,
                std::pair<int, int> needed) {
  const int begin = std::max(rows.first, needed.first), end = std::min(rows.second, needed.second);
  if (begin < end) list.push_back({named, begin, end});
}

std::pair<int, int> rows_of(std::span<const int> begins, int rank) {
  return {begins[static_cast<std::size_t>(rank)], begins[static_cast<std::size_t>(rank) + 1]};
}

}  // namespace

std::vector<RowsOfRank> rows_to_receive(std::span<const int> begins, int rank, int below,
                                        int above) {
  std::vector<RowsOfRank> list;
  const auto [begin, end] = rows_of(begins, rank);
  for (int other = 0; other + 1 < static_cast<int>(begins.size()); ++other) {
    if (other == rank) continue;
    add_common(list, other, rows_of(begins, other), {begin - below, begin});
    add_common(list, other, rows_of(begins, other), {end, end + above});
  }
  return list;
}

std::vector<RowsOfRank> rows_to_send(std::span<const int> begins, int rank, int below, int above) {
  std::vector<RowsOfRank> list;
  for (int other = 0; other + 1 < static_cast<int>(begins.size()); ++other) {
    if (other == rank) continue;
    const auto [begin, end] = rows_of(begins, other);
    add_common(list, other, rows_of(begins, rank), {begin - below, begin});
    add_common(list, other, rows_of(begins, rank), {end, end + above});
  }
  return list;
}

void RowSum::end_row() {
  if (row_ < 0) return;
  if (slab_.is_whole())
    total_ += sum_;
  else
    of_rows_.push_back(sum_);
  sum_ = 0.0;
}

double RowSum::value() {
  end_row();
  row_ = -1;
  if (slab_.is_whole()) return total_;
  for (const double of_row : slab_.ranks->gather(bytes_to_send(of_rows_)).as<double>())
    total_ += of_row;
  of_rows_.clear();
  return total_;
}

void complete_rows(const Slab& slab, std::span<double> of_row) {
  if (!slab.is_whole())
    slab.ranks->complete(std::as_writable_bytes(of_row), sizeof(double), slab.begins);
}

}  // namespace hackle
