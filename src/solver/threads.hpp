// SPDX-License-Identifier: MIT
// A fixed number of threads that share tasks.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

#include <memory>
#include <optional>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

namespace hackle {

// oneTBB is not instrumented: ThreadSanitizer must be told that what came before release() on one
// thread is seen after acquire() on another. Nothing in other builds.
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

class Threads {
 public:
  // count >= 1; more than there are cores is allowed, and slower.
  explicit Threads(int count) : pool_(std::make_shared<Pool>(count)) {}

  int count() const { return pool_->arena.max_concurrency(); }

  // Calls work(task, thread) for 0 <= task < tasks, with thread < count() saying on which thread;
  // returns when all are done.
  template <class Work>
  void for_tasks(int tasks, const Work& work) const {
    if (count() == 1 || tasks == 1) {
      for (int task = 0; task < tasks; ++task) work(task, 0);
      return;
    }
    Handover start, end;
    const auto part = [&](const tbb::blocked_range<int>& range) {
      start.acquire();
      for (int task = range.begin(); task < range.end(); ++task)
        work(task, tbb::this_task_arena::current_thread_index());
      end.release();
    };
    start.release();
    pool_->arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<int>(0, tasks), part, tbb::simple_partitioner{});
    });
    end.acquire();
  }

 private:
  struct Pool {
    explicit Pool(int count) : arena(count) {
      // oneTBB gives no more threads than cores, and says so on stderr, unless it is told to.
      if (count > tbb::info::default_concurrency())
        permission.emplace(tbb::global_control::max_allowed_parallelism, count);
    }
    std::optional<tbb::global_control> permission;
    tbb::task_arena arena;
  };
  std::shared_ptr<Pool> pool_;  // shared, so that a simulation can be copied
};

}  // namespace hackle
