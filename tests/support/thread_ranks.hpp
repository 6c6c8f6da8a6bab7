// SPDX-License-Identifier: MIT
// Ranks that are threads of a test instead of processes.
#pragma once

#include <barrier>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/ranks/ranks.hpp"

namespace hackle::test {

class ThreadRanks {
 public:
  explicit ThreadRanks(int count)
      : count_(count), given_(static_cast<std::size_t>(count)), meeting_(count) {}

  // Calls work(Ranks&) on every rank; throws what the first of them threw.
  template <class Work>
  void run(const Work& work) {
    std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count_));
    {
      std::vector<std::jthread> threads;
      for (int rank = 0; rank < count_; ++rank)
        threads.emplace_back([&, rank] {
          Member member(*this, rank);
          try {
            work(static_cast<Ranks&>(member));
          } catch (...) {
            thrown[static_cast<std::size_t>(rank)] = std::current_exception();
          }
        });
    }
    for (const std::exception_ptr& one : thrown)
      if (one) std::rethrow_exception(one);
  }

 private:
  using Bytes = std::vector<std::byte>;

  class Member final : public Ranks {
   public:
    Member(ThreadRanks& all, int rank) : all_(all), rank_(rank) {}

    int rank() const override { return rank_; }
    int count() const override { return all_.count_; }

    void begin_exchange(std::span<const Outgoing> sent,
                        std::span<const Incoming> received) override {
      for (const Outgoing& message : sent) {
        const std::lock_guard lock(all_.mutex_);
        all_.post_[{rank_, message.to}].emplace_back(message.bytes.begin(), message.bytes.end());
        all_.arrives_.notify_all();
        count_in(message.bytes.size());
      }
      awaited_.assign(received.begin(), received.end());
    }

    void end_exchange() override {
      for (const Incoming& message : awaited_) {
        std::unique_lock lock(all_.mutex_);
        std::deque<Bytes>& post = all_.post_[{message.from, rank_}];
        all_.arrives_.wait(lock, [&] { return !post.empty(); });
        if (post.front().size() != message.bytes.size()) std::abort();
        std::memcpy(message.bytes.data(), post.front().data(), message.bytes.size());
        post.pop_front();
      }
    }

    Gathered gather(std::span<const std::byte> own) override {
      all_.given_[static_cast<std::size_t>(rank_)].assign(own.begin(), own.end());
      all_.meeting_.arrive_and_wait();
      Gathered gathered{{}, {0}};
      for (const Bytes& bytes : all_.given_) {
        gathered.bytes.insert(gathered.bytes.end(), bytes.begin(), bytes.end());
        gathered.begins.push_back(gathered.bytes.size());
      }
      all_.meeting_.arrive_and_wait();
      count_in(own.size());
      return gathered;
    }

    void complete(std::span<std::byte> array, std::size_t row_bytes,
                  std::span<const int> begins) override {
      const auto place = [&](int rank) {
        return static_cast<std::size_t>(begins[static_cast<std::size_t>(rank)]) * row_bytes;
      };
      const Gathered all = gather(array.subspan(place(rank_), place(rank_ + 1) - place(rank_)));
      std::memcpy(array.data(), all.bytes.data(), all.bytes.size());
    }

    std::uint64_t any(std::uint64_t bits) override {
      std::uint64_t all = 0;
      const std::vector<std::uint64_t> own{bits};
      for (const std::uint64_t one : gather(bytes_to_send(own)).as<std::uint64_t>()) all |= one;
      return all;
    }

    void share(std::string& text) override {
      const Gathered all = gather(std::as_bytes(std::span(text)));
      text.assign(reinterpret_cast<const char*>(all.bytes.data()), all.begins[1]);
    }

    bool meet(double) override {
      all_.meeting_.arrive_and_wait();
      return true;
    }
    void end_all(int, const std::string&) override { std::abort(); }
    Traffic traffic() const override { return traffic_; }

   private:
    void count_in(std::size_t bytes) {
      ++traffic_.messages;
      traffic_.bytes += static_cast<std::int64_t>(bytes);
    }

    ThreadRanks& all_;
    int rank_;
    std::vector<Incoming> awaited_;
    Traffic traffic_;
  };

  int count_;
  std::mutex mutex_;
  std::condition_variable arrives_;
  std::map<std::pair<int, int>, std::deque<Bytes>> post_;
  std::vector<Bytes> given_;
  std::barrier<> meeting_;
};

}  // namespace hackle::test
