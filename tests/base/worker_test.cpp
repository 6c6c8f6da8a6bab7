// SPDX-License-Identifier: MIT
#include "base/worker.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Worker, DoesEveryJobInOrder) {
  std::vector<int> done;
  Worker<int> worker(3, [&](int job) { done.push_back(job); });
  for (int job = 0; job < 100; ++job) worker.push(job);
  worker.finish();
  ASSERT_EQ(done.size(), 100U);
  for (int job = 0; job < 100; ++job) EXPECT_EQ(done[static_cast<std::size_t>(job)], job);
}

TEST(Worker, NeverHoldsMoreThanItsCapacity) {
  std::atomic<int> waiting = 0;
  std::atomic<int> max = 0;
  Worker<int> worker(2, [&](int) { --waiting; });
  for (int job = 0; job < 200; ++job) {
    worker.push(job);
    max = std::max(max.load(), ++waiting);
  }
  worker.finish();
  // Two in the queue, one being processed, and one counted before its push returned.
  EXPECT_LE(max, 4);
}

TEST(Worker, HandsItsFailureToThePusher) {
  Worker<int> worker(1, [](int job) {
    if (job == 1) throw std::runtime_error("disk full");
  });
  EXPECT_THROW(
      {
        for (int job = 0; job < 1000; ++job) worker.push(job);
      },
      std::runtime_error);
  EXPECT_THROW(worker.finish(), std::runtime_error);
}

TEST(Worker, EndsItsJobsWhenItIsDestroyed) {
  std::atomic<int> done = 0;
  {
    Worker<int> worker(8, [&](int) { ++done; });
    for (int job = 0; job < 8; ++job) worker.push(job);
  }
  EXPECT_EQ(done, 8);
}

}  // namespace
}  // namespace hackle
