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

class CheckpointKeeper : public Observer {
 public:
  // Every `seconds` of wall time. `place` is asked for the file when it is first needed; it may
  // throw: then there are no checkpoints, which is said. No function throws.
  CheckpointKeeper(double seconds, std::function<std::filesystem::path()> place, Origin origin,
                   Talk talk);
  // Waits for a file that is being written.
  ~CheckpointKeeper() override;

  std::int64_t next_due(const Simulation& simulation) override;
  bool due(const Simulation& simulation) override;
  // Copies the state; a thread writes it, and the run goes on meanwhile.
  void observe(const Simulation& simulation) override;
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
  std::function<std::filesystem::path()> place_;
  Origin origin_;
  Talk talk_;
  Clock::time_point last_ = Clock::now();
  std::optional<std::filesystem::path> path_;
  std::future<void> writing_;
  bool hopeless_ = false;
};

}  // namespace hackle
