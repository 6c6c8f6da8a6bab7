// SPDX-License-Identifier: MIT
// A run that goes on bit by bit, beside other work: who looks on, and whether it is paused.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "output/files/checkpoint_keeper.hpp"
#include "output/run/progress_observer.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class RunLoop {
 public:
  // Throws Error (refused) while a function of the script is called in the middle of a run.
  void refuse_while_running() const;
  // Whether that function may change loads: it is called between two steps.
  bool is_watched() const { return activity_ == Activity::watched; }
  // Functions of time or place are called as long as this lives.
  Mark mark_busy() { return Mark(activity_, Activity::stepping); }

  void watch(std::shared_ptr<Observer> watcher);
  // Their functions may hold on to the run.
  void forget_watchers() { watchers_.clear(); }
  // Keeps checkpoints of what is done from now on; see CheckpointKeeper.
  void keep_checkpoints(double seconds, CheckpointHost host, const Origin& origin, Talk talk) {
    keeper_.emplace(seconds, std::move(host), origin, talk);
  }
  // Keeps the present state, if checkpoints are kept.
  void keep_last(const Simulation& simulation) {
    if (keeper_) keeper_->keep_last(simulation);
  }
  // Waits until the last checkpoint is written.
  void finish_checkpoints() const {
    if (keeper_) keeper_->wait();
  }
  // These, the watchers and the keeper of checkpoints: what it keeps is behind all of them.
  std::vector<Observer*> with_watchers(std::vector<Observer*> observers);
  // Does work on the simulation, and keeps its last state if that throws.
  template <class Work>
  void keeping(const Simulation& simulation, const Work& work) {
    try {
      work();
    } catch (...) {
      keep_last(simulation);
      throw;
    }
  }

  // Goes on until the simulation arrives or one of the observers breaks it off. After an error, but
  // not after an interrupt, nothing is under way any more.
  void go_on(Simulation& simulation, std::vector<Observer*> observers);
  // The step after which Ctrl-C last interrupted it; told once.
  std::optional<std::int64_t> take_interrupt() { return std::exchange(interrupted_at_, {}); }

  void pause() { paused_ = true; }
  void resume() { paused_ = false; }
  bool paused() const { return paused_; }

 private:
  Activity activity_ = Activity::none;
  std::deque<Watched> watchers_;  // which refer to the activity
  bool paused_ = false;
  std::optional<std::int64_t> interrupted_at_;
  std::optional<CheckpointKeeper> keeper_;
};

}  // namespace hackle
