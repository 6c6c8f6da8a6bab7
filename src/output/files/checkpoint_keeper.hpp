// SPDX-License-Identifier: MIT
// Keeps the state of a run in a file from time to time, and when the run ends early.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>

#include "base/origin.hpp"
#include "base/progress.hpp"
#include "solver/observer.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Who keeps the checkpoints of a run, and what they hold beside its state.
struct CheckpointHost {
  // Asked for the file when it is first needed; may throw: then there are no checkpoints.
  std::function<std::filesystem::path()> place;
  // Returns what is needed beside the state to go on; see Checkpoint::continuation.
  std::function<std::string()> continuation;
  // Returns a function that returns when the disk has what the outputs have seen by then.
  std::function<std::function<void()>()> settled;
};

class CheckpointKeeper : public Observer {
 public:
  // Every `seconds` of wall time. What the host throws is said, and ends the checkpoints, not the
  // run. No function throws.
  CheckpointKeeper(double seconds, CheckpointHost host, Origin origin, Talk talk);
  // Waits for a file that is being written.
  ~CheckpointKeeper() override;

  std::int64_t next_due(const Simulation& simulation) override;
  bool due(const Simulation& simulation) override;
  // Copies the state; a thread writes it, and the run goes on meanwhile.
  void observe(const Simulation& simulation) override;
  // Waits for a file that is being written.
  void wait() const {
    if (writing_.valid()) writing_.wait();
  }
  // Keeps the last state and says where, unless it has diverged.
  void keep_last(const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;
  void keep(const Simulation& simulation);
  bool is_writing() const;
  void collect();  // the outcome of the last writing, which it waits for
  template <class Work>
  void attempt(const Work& work);

  Clock::duration interval_;
  CheckpointHost host_;
  Origin origin_;
  Talk talk_;
  Clock::time_point last_ = Clock::now();
  std::optional<std::filesystem::path> path_;
  std::future<void> writing_;
  bool hopeless_ = false;
};

}  // namespace hackle
