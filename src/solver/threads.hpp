// SPDX-License-Identifier: MIT
// Work on the rows of the lattice with a fixed number of threads.
#pragma once

#include <memory>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

namespace hackle {

class Threads {
 public:
  // Rows of one task: enough work to hide the cost of handing it out, few enough to balance.
  static constexpr int rows_per_task = 8;

  explicit Threads(int count) : arena_(std::make_shared<tbb::task_arena>(count)) {}

  int count() const { return arena_->max_concurrency(); }

  // Calls work(row_begin, row_end) on ranges that cover 0..rows; returns when all are done.
  template <class Work>
  void for_rows(int rows, const Work& work) const {
    const tbb::blocked_range<int> range(0, rows, rows_per_task);
    const auto task = [&](const tbb::blocked_range<int>& part) { work(part.begin(), part.end()); };
    if (count() == 1) return task(range);
    arena_->execute([&] { tbb::parallel_for(range, task, tbb::simple_partitioner{}); });
  }

 private:
  std::shared_ptr<tbb::task_arena> arena_;  // shared, so that a simulation can be copied
};

}  // namespace hackle
