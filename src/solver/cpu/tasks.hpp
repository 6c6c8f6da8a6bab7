// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/cpu/kernel.hpp"

namespace hackle {

// The row of tiles of every row of nodes. `first_rows` is that of tile_rows(), here as below.
std::vector<int> rows_to_tiles(const std::vector<int>& first_rows);

// Shares rows of tiles out in tasks: a few tasks per thread, so that a preempted thread delays the
// step only briefly, but not so many that bonds between tasks, which both compute, cost much.
std::vector<Rows> share_out(const std::vector<int>& first_rows, int threads);

}  // namespace hackle
