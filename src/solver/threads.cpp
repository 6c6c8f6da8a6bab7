// SPDX-License-Identifier: MIT
#include "solver/threads.hpp"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

#include <optional>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

namespace hackle {
namespace {

// oneTBB is not instrumented: this tells ThreadSanitizer that writes before release() on one thread
// are visible after acquire() on another. Empty in other builds.
struct Handover {
#ifdef __SANITIZE_THREAD__
  void release() {
    __tsan_release(this);
  }
  void acquire() {
    __tsan_acquire(this);
  }
#else
  void release() {
  }
  void acquire() {
  }
#endif
};

}  // namespace

struct Threads::Pool {
  explicit Pool(int count) : arena(count) {
    // Unless told otherwise, oneTBB uses at most as many threads as cores, and reports that on
    // stderr.
    if (count > tbb::info::default_concurrency())
      permission.emplace(tbb::global_control::max_allowed_parallelism, count);
  }
  std::optional<tbb::global_control> permission;
  tbb::task_arena arena;
};

Threads::Threads(int count) : pool_(std::make_shared<Pool>(count)) {
  count_ = pool_->arena.max_concurrency();
}

void Threads::share(int tasks, const Task& task) const {
  Handover start, end;
  const auto part = [&](const tbb::blocked_range<int>& range) {
    start.acquire();
    for (int k = range.begin(); k < range.end(); ++k)
      task.call(task.work, k, tbb::this_task_arena::current_thread_index());
    end.release();
  };
  start.release();
  pool_->arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, tasks), part, tbb::simple_partitioner{});
  });
  end.acquire();
}

}  // namespace hackle
