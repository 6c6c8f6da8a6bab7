// SPDX-License-Identifier: MIT
// The times at which an output sees the state.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "solver/observer.hpp"
#include "solver/simulation.hpp"
#include "solver/view.hpp"

namespace hackle {

// The times start + k * every, k = 0, 1, ..., which are reached by the first step at or after them;
// what is shown is the plate at that very time (see Instant).
class Schedule {
 public:
  // Starts at the present time. Where `every`, in s, is less than a step, its times are those of
  // all steps. Throws Error (refused) if it is no number above 0. `output` names the caller.
  Schedule(const char* output, double every, const View& view);

  bool reached(const View& view) const;
  // Returns the time that has been reached, s, or that of the view if it lies too far back.
  double moment(const View& view) const;
  // A step before which it is not reached.
  std::int64_t next_due(const View& view) const;
  // Returns how many times lie between the start and `until`, s; at most `max_more` of them to
  // come.
  std::int64_t moments(double until, std::int64_t max_more) const;
  // Advances to the next time that has not passed: quasi-static loading may pass several at once.
  void advance(const View& view);
  // Where it starts, s, and how many times have passed; go_on() puts another one of the same
  // interval there.
  double start() const { return start_; }
  std::int64_t passed() const { return next_; }
  void go_on(double start, std::int64_t passed) {
    start_ = start;
    next_ = passed;
  }
  // Says that its times are those of all steps; empty if they are not.
  const std::string& remark() const { return remark_; }

 private:
  double next() const { return start_ + static_cast<double>(next_) * every_; }

  double start_;
  double every_;
  std::int64_t next_ = 0;
  std::string remark_;
};

// An observer that looks at the times of a schedule.
class ScheduledObserver : public Observer {
 public:
  explicit ScheduledObserver(Schedule schedule) : schedule_(std::move(schedule)) {}

  std::int64_t next_due(const Simulation& simulation) override {
    return schedule_.next_due(simulation);
  }
  bool due(const Simulation& simulation) override { return schedule_.reached(simulation); }
  double moment(const Simulation& simulation) final { return schedule_.moment(simulation); }
  void observe(const Simulation& simulation) final {
    schedule_.advance(simulation);
    look(simulation);
  }
  std::string remark() const final { return schedule_.remark(); }

 protected:
  virtual void look(const Simulation& simulation) = 0;
  const Schedule& schedule() const { return schedule_; }
  Schedule& schedule() { return schedule_; }

 private:
  Schedule schedule_;
};

}  // namespace hackle
