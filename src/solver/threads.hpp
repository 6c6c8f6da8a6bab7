// SPDX-License-Identifier: MIT
// A fixed number of threads that share tasks.
#pragma once

#include <memory>

namespace hackle {

class Threads {
 public:
  // count >= 1; more than the number of cores is allowed, but slower.
  explicit Threads(int count);

  int count() const { return count_; }

  // Calls work(task, thread) for 0 <= task < tasks, where thread < count() is the index of the
  // thread; returns when all are done.
  template <class Work>
  void for_tasks(int tasks, const Work& work) const {
    if (count_ == 1 || tasks == 1) {
      for (int task = 0; task < tasks; ++task) work(task, 0);
      return;
    }
    share(tasks, {&work, [](const void* of, int task, int thread) {
                    (*static_cast<const Work*>(of))(task, thread);
                  }});
  }

 private:
  // Work of any type; it outlives the call that it is handed to.
  struct Task {
    const void* work;
    void (*call)(const void* work, int task, int thread);
  };
  struct Pool;

  void share(int tasks, const Task& task) const;

  int count_;
  std::shared_ptr<Pool> pool_;  // shared, so that a simulation can be copied
};

}  // namespace hackle
