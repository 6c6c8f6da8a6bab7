// SPDX-License-Identifier: MIT
#include "solver/cpu/tasks.hpp"

#include <algorithm>

namespace hackle {

std::vector<int> rows_to_tiles(const std::vector<int>& first_rows) {
  std::vector<int> tile_row;
  for (int t = 0; t + 1 < static_cast<int>(first_rows.size()); ++t)
    tile_row.resize(static_cast<std::size_t>(first_rows[static_cast<std::size_t>(t) + 1]), t);
  return tile_row;
}

std::vector<Rows> share_out(const std::vector<int>& first_rows, int threads) {
  constexpr int max_per_thread = 4, min_rows = 4;
  const auto rows = static_cast<int>(first_rows.size()) - 1;
  const int per_thread = std::clamp(rows / (threads * min_rows), 1, max_per_thread);
  const int tasks = threads == 1 ? 1 : std::min(rows, threads * per_thread);
  std::vector<Rows> list;
  list.reserve(static_cast<std::size_t>(tasks));
  for (int task = 0; task < tasks; ++task)
    list.push_back({first_rows[static_cast<std::size_t>(rows * task / tasks)],
                    first_rows[static_cast<std::size_t>(rows * (task + 1) / tasks)]});
  return list;
}

}  // namespace hackle
