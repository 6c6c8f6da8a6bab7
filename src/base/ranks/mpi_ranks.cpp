// SPDX-License-Identifier: MIT
// Ranks of MPI. The only source that knows it: a module, see mpi_module.hpp.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include "base/ranks/mpi_module.hpp"

namespace hackle {
namespace {

using Clock = std::chrono::steady_clock;

// The program may silence stderr on some ranks; what ends all of them is said all the same.
const int stderr_at_start = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);

int number_of_bytes(std::size_t count) {
  return static_cast<int>(
      count);  // no message of ours comes near 2 GB: rows are a type of their own
}

// Asks the ranks who is there: those that wait too long ask at about the same time. On a
// communicator of its own, by a thread of its own.
class RollCall {
 public:
  RollCall() {
    MPI_Comm_dup(MPI_COMM_WORLD, &ranks_);
    MPI_Comm_rank(ranks_, &rank_);
    MPI_Comm_size(ranks_, &count_);
  }

  int rank() const { return rank_; }
  // Returns those that have not answered after some seconds.
  std::vector<int> missing(double seconds) const {
    std::vector<char> heard(static_cast<std::size_t>(count_));
    std::vector<MPI_Request> answers, calls;
    const char here = 1;
    for (int other = 0; other < count_; ++other) {
      if (other == rank_) continue;
      MPI_Irecv(&heard[static_cast<std::size_t>(other)], 1, MPI_CHAR, other, 0, ranks_,
                &answers.emplace_back());
      MPI_Isend(&here, 1, MPI_CHAR, other, 0, ranks_, &calls.emplace_back());
    }
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    for (int all = 0; all == 0 && Clock::now() < end;) {
      MPI_Testall(static_cast<int>(answers.size()), answers.data(), &all, MPI_STATUSES_IGNORE);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::vector<int> list;
    for (int other = 0; other < count_; ++other)
      if (other != rank_ && heard[static_cast<std::size_t>(other)] == 0) list.push_back(other);
    return list;
  }

 private:
  MPI_Comm ranks_ = MPI_COMM_NULL;
  int rank_ = 0, count_ = 0;
};

// Ends this process when a call has waited too long. MPI then ends the others.
class Watchdog {
 public:
  explicit Watchdog(double patience) : patience_(patience) {
    if (patience > 0.0)
      thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  }

  void begin() { since_ = Clock::now().time_since_epoch().count(); }
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

  // Others may come a little later to the same end.
  [[noreturn]] void give_up() const {
    const std::vector<int> missing = roll_call_.missing(std::min(2.0, patience_));
    std::string who;
    for (const int rank : missing) who += (who.empty() ? "rank " : ", ") + std::to_string(rank);
    // The first that is there speaks; the others leave it time to.
    int first = 0;
    while (std::ranges::find(missing, first) != missing.end()) ++first;
    if (roll_call_.rank() != first) std::this_thread::sleep_for(std::chrono::seconds(2));
    dprintf(stderr_at_start, "hackle: error: rank %d has waited %g s for %s, which %s\n",
            roll_call_.rank(), patience_, who.empty() ? "a call of others" : who.c_str(),
            who.empty() ? "make another one: the script has diverged"
                        : "hangs or swaps, or computes something else");
    std::_Exit(1);
  }

  RollCall roll_call_;
  double patience_;
  std::atomic<Clock::rep> since_{0};
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::jthread thread_;  // last, so that it ends first
};

class MpiRanks final : public Ranks {
 public:
  explicit MpiRanks(double patience)
      : rank_(number(MPI_Comm_rank)), count_(number(MPI_Comm_size)), watchdog_(patience) {
    MPI_Comm_dup(MPI_COMM_WORLD, &farewell_);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void begin_exchange(std::span<const Outgoing> sent, std::span<const Incoming> received) override {
    requests_.clear();
    for (const Incoming& message : received) {
      MPI_Irecv(message.bytes.data(), number_of_bytes(message.bytes.size()), MPI_BYTE, message.from,
                0, MPI_COMM_WORLD, &requests_.emplace_back());
    }
    for (const Outgoing& message : sent) {
      MPI_Isend(message.bytes.data(), number_of_bytes(message.bytes.size()), MPI_BYTE, message.to,
                0, MPI_COMM_WORLD, &requests_.emplace_back());
      count_in(message.bytes.size());
    }
  }

  void end_exchange() override {
    const Waiting waiting(watchdog_);
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  }

  Gathered gather(std::span<const std::byte> own) override {
    const Waiting waiting(watchdog_);
    std::vector<int> sizes(static_cast<std::size_t>(count_));
    const int size = number_of_bytes(own.size());
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
    if (std::accumulate(sizes.begin(), sizes.end(), 0.0) > std::numeric_limits<int>::max())
      end_all(1, "hackle: error: the ranks have more than 2 GB to tell each other in a step\n");
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
    dprintf(stderr_at_start, "%s", text.c_str());
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

  Traffic traffic() const override { return traffic_; }

 private:
  class Waiting {
   public:
    explicit Waiting(Watchdog& watchdog) : watchdog_(watchdog) { watchdog_.begin(); }
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
  Traffic traffic_;
};

}  // namespace
}  // namespace hackle

extern "C" hackle::Ranks* hackle_mpi_ranks(double patience);

extern "C" hackle::Ranks* hackle_mpi_ranks(double patience) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
  static hackle::MpiRanks ranks(patience);
  std::atexit([] { MPI_Finalize(); });
  return &ranks;
}
