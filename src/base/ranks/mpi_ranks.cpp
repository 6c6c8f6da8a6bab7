// SPDX-License-Identifier: MIT
// Ranks of MPI. The only source that knows it: a module, see mpi_module.hpp.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <numeric>
#include <thread>

#include <mpi.h>

#include "base/ranks/mpi_module.hpp"

namespace hackle {
namespace {

using Clock = std::chrono::steady_clock;

int number_of_bytes(std::size_t count) {
  return static_cast<int>(
      count);  // no message of ours comes near 2 GB: rows are a type of their own
}

// Ends this process when a call has waited too long. MPI then ends the others.
class Watchdog {
 public:
  Watchdog(double patience, int rank) : patience_(patience), rank_(rank) {
    if (patience > 0.0)
      thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  }

  void begin(int expected) {
    expected_ = expected;
    since_ = Clock::now().time_since_epoch().count();
  }
  void expect(int rank) { expected_ = rank; }
  void end() { since_ = 0; }

 private:
  void watch(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!wakes_.wait_for(lock, stop, std::chrono::milliseconds(250), [] { return false; }) &&
           !stop.stop_requested()) {
      const Clock::rep since = since_;
      const std::chrono::duration<double> waited =
          Clock::now().time_since_epoch() - Clock::duration(since);
      if (since != 0 && waited.count() > patience_) give_up();
    }
  }

  [[noreturn]] void give_up() const {
    const int expected = expected_;
    if (expected >= 0)
      std::fprintf(stderr,
                   "hackle: error: rank %d has waited %g s for rank %d, which hangs, swaps or has "
                   "diverged\n",
                   rank_, patience_, expected);
    else
      std::fprintf(
          stderr,
          "hackle: error: rank %d has waited %g s for the other ranks, of which one hangs, "
          "swaps or has diverged\n",
          rank_, patience_);
    std::_Exit(1);
  }

  double patience_;
  int rank_;
  std::atomic<Clock::rep> since_{0};
  std::atomic<int> expected_{-1};  // the rank that is waited for; -1: all
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::jthread thread_;  // last, so that it ends first
};

class MpiRanks final : public Ranks {
 public:
  explicit MpiRanks(double patience)
      : rank_(number(MPI_Comm_rank)), count_(number(MPI_Comm_size)), watchdog_(patience, rank_) {
    MPI_Comm_dup(MPI_COMM_WORLD, &farewell_);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void begin_exchange(std::span<const Outgoing> sent, std::span<const Incoming> received) override {
    requests_.clear();
    from_.clear();
    for (const Incoming& message : received) {
      MPI_Irecv(message.bytes.data(), number_of_bytes(message.bytes.size()), MPI_BYTE, message.from,
                0, MPI_COMM_WORLD, &requests_.emplace_back());
      from_.push_back(message.from);
    }
    for (const Outgoing& message : sent) {
      MPI_Isend(message.bytes.data(), number_of_bytes(message.bytes.size()), MPI_BYTE, message.to,
                0, MPI_COMM_WORLD, &requests_.emplace_back());
      from_.push_back(message.to);
      count_in(message.bytes.size());
    }
  }

  void end_exchange() override {
    watchdog_.begin(-1);
    for (std::size_t open = requests_.size(); open > 0; --open) {
      for (std::size_t k = 0; k < requests_.size(); ++k)
        if (requests_[k] != MPI_REQUEST_NULL) {
          watchdog_.expect(from_[k]);
          break;
        }
      int index = 0;
      MPI_Waitany(static_cast<int>(requests_.size()), requests_.data(), &index, MPI_STATUS_IGNORE);
    }
    watchdog_.end();
  }

  Gathered gather(std::span<const std::byte> own) override {
    const Waiting waiting(watchdog_);
    std::vector<int> sizes(static_cast<std::size_t>(count_));
    const int size = number_of_bytes(own.size());
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::vector<int> begins(sizes.size() + 1);
    std::partial_sum(sizes.begin(), sizes.end(), begins.begin() + 1);
    Gathered all{std::vector<std::byte>(static_cast<std::size_t>(begins.back())),
                 {begins.begin(), begins.end()}};
    if (!all.bytes.empty())
      MPI_Allgatherv(own.data(), size, MPI_BYTE, all.bytes.data(), sizes.data(), begins.data(),
                     MPI_BYTE, MPI_COMM_WORLD);
    count_in(own.size());
    return all;
  }

  void complete(std::span<std::byte> array, std::size_t row_bytes,
                std::span<const int> begins) override {
    const Waiting waiting(watchdog_);
    MPI_Datatype row = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(number_of_bytes(row_bytes), MPI_BYTE, &row);
    MPI_Type_commit(&row);
    std::vector<int> rows;
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) rows.push_back(begins[k + 1] - begins[k]);
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, array.data(), rows.data(), begins.data(),
                   row, MPI_COMM_WORLD);
    MPI_Type_free(&row);
    count_in(row_bytes * static_cast<std::size_t>(rows[static_cast<std::size_t>(rank_)]));
  }

  std::uint64_t any(std::uint64_t bits) override {
    const Waiting waiting(watchdog_);
    std::uint64_t all = 0;
    MPI_Allreduce(&bits, &all, 1, MPI_UINT64_T, MPI_BOR, MPI_COMM_WORLD);
    count_in(sizeof bits);
    return all;
  }

  void share(std::string& text) override {
    const Waiting waiting(watchdog_);
    int size = number_of_bytes(text.size());
    MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), size, MPI_BYTE, 0, MPI_COMM_WORLD);
    if (rank_ == 0) count_in(text.size());
  }

  // On a communicator of its own: others may be in the middle of another call.
  bool meet(double seconds) override {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(farewell_, &request);
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    for (;;) {
      int done = 0;
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (done != 0) return true;
      if (Clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  void end_all(int exit_code, const std::string& text) override {
    std::fputs(text.c_str(), stderr);
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

  Traffic traffic() const override { return traffic_; }

 private:
  class Waiting {
   public:
    explicit Waiting(Watchdog& watchdog) : watchdog_(watchdog) { watchdog_.begin(-1); }
    ~Waiting() { watchdog_.end(); }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

   private:
    Watchdog& watchdog_;
  };

  static int number(int (*query)(MPI_Comm, int*)) {
    int number = 0;
    query(MPI_COMM_WORLD, &number);
    return number;
  }
  void count_in(std::size_t bytes) {
    ++traffic_.messages;
    traffic_.bytes += static_cast<std::int64_t>(bytes);
  }

  int rank_, count_;
  MPI_Comm farewell_ = MPI_COMM_NULL;
  Watchdog watchdog_;
  std::vector<MPI_Request> requests_;
  std::vector<int> from_;  // the other end of each
  Traffic traffic_;
};

}  // namespace
}  // namespace hackle

extern "C" hackle::Ranks* hackle_mpi_ranks(double patience);

extern "C" hackle::Ranks* hackle_mpi_ranks(double patience) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  static hackle::MpiRanks ranks(patience);
  std::atexit([] { MPI_Finalize(); });
  return &ranks;
}
