// SPDX-License-Identifier: MIT
// Observers of a run other than its outputs.
#pragma once

#include <chrono>
#include <limits>
#include <memory>

#include "base/progress.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Shows the progress of a run.
class ProgressObserver : public Observer {
 public:
  // Covers `start` to `end`, s.
  ProgressObserver(Talk talk, double start, double end)
      : progress_(talk), start_(start), end_(end) {}

  bool due(const Simulation& simulation) override { return progress_.due(fraction(simulation)); }
  void observe(const Simulation& simulation) override;
  bool looks_at_nodes() const override { return false; }

 private:
  double fraction(const Simulation& simulation) const;

  Progress progress_;
  double start_, end_;
};

// The activity of a run while a function of the script is called.
enum class Activity { none, stepping, watched };

// Sets the activity while it lives.
class Mark {
 public:
  Mark(Activity& activity, Activity now) : activity_(activity), before_(activity) {
    activity_ = now;
  }
  ~Mark() { activity_ = before_; }
  Mark(const Mark&) = delete;
  Mark& operator=(const Mark&) = delete;

 private:
  Activity& activity_;
  Activity before_;
};

// Calls a watcher, which may do more than a function of time.
class Watched : public Observer {
 public:
  Watched(std::shared_ptr<Observer> watcher, Activity& activity)
      : watcher_(std::move(watcher)), activity_(activity) {}

  std::int64_t next_due(const Simulation& simulation) override {
    return watcher_->next_due(simulation);
  }
  bool due(const Simulation& simulation) override { return watcher_->due(simulation); }
  double moment(const Simulation& simulation) override { return watcher_->moment(simulation); }
  void observe(const Simulation& simulation) override {
    const Mark mark(activity_, Activity::watched);
    watcher_->observe(simulation);
  }

 private:
  std::shared_ptr<Observer> watcher_;
  Activity& activity_;
};

// Ends the run when the wall time is used up, but not before the first step, or after a number of
// steps.
class Break : public Observer {
 public:
  explicit Break(Simulation& simulation)
      : simulation_(simulation), start_(simulation.state().step) {}
  void after_seconds(double seconds);
  void after_step(std::int64_t step) { last_ = step; }

  bool due(const Simulation& simulation) override;
  void observe(const Simulation&) override {}

 private:
  using Clock = std::chrono::steady_clock;
  Simulation& simulation_;
  std::int64_t start_;
  Clock::time_point end_ = Clock::time_point::max();
  std::int64_t last_ = std::numeric_limits<std::int64_t>::max();
};

// Repeats a Ctrl-C of the prompt in a script: throws Error (interrupted) once, after a given step.
class Interrupt : public Observer {
 public:
  explicit Interrupt(std::int64_t step) : step_(step) {}

  std::int64_t next_due(const Simulation&) override { return step_; }
  bool due(const Simulation& simulation) override {
    return !done_ && simulation.state().step >= step_;
  }
  void observe(const Simulation& simulation) override;

 private:
  std::int64_t step_;
  bool done_ = false;
};

}  // namespace hackle
