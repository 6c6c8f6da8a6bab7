// SPDX-License-Identifier: MIT
// A thread with a bounded queue: pictures and movies are made on it, beside the solver.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace hackle {

// Runs `work` on each pushed job, in order, on its own thread. If `work` throws, the waiting jobs
// are dropped and the next push() or finish() rethrows the exception.
template <class Job>
class Worker {
 public:
  Worker(std::size_t capacity, std::function<void(Job)> work)
      : capacity_(capacity), work_(std::move(work)), thread_([this] { loop(); }) {}

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Completes the queued jobs. An exception that finish() has not collected is lost.
  ~Worker() { close(); }

  // Waits while the queue is full.
  void push(Job job) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return jobs_.size() < capacity_ || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    jobs_.push_back(std::move(job));
    work_waits_.notify_one();
  }

  // Waits until every queued job is done. Further pushes are not allowed.
  void finish() {
    close();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    work_waits_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  void loop() {
    std::unique_lock lock(mutex_);
    for (;;) {
      work_waits_.wait(lock, [this] { return !jobs_.empty() || closed_; });
      if (jobs_.empty()) return;
      Job job = std::move(jobs_.front());
      jobs_.pop_front();
      room_.notify_one();
      lock.unlock();
      const std::exception_ptr failure = attempt(std::move(job));
      lock.lock();
      if (!failure) continue;
      failure_ = failure;
      jobs_.clear();
      room_.notify_all();
      return;
    }
  }

  std::exception_ptr attempt(Job job) {
    try {
      work_(std::move(job));
      return nullptr;
    } catch (...) {
      return std::current_exception();
    }
  }

  const std::size_t capacity_;
  const std::function<void(Job)> work_;
  std::mutex mutex_;
  std::condition_variable room_, work_waits_;
  std::deque<Job> jobs_;
  std::exception_ptr failure_;
  bool closed_ = false;
  std::thread thread_;  // declared last: it uses all of the above
};

}  // namespace hackle
