// SPDX-License-Identifier: MIT
// An observer that calls functions of the script: in a replay they are called again.
#pragma once

#include <memory>
#include <utility>

#include "console/replay/replay.hpp"
#include "solver/observer.hpp"

namespace hackle {

class ReplayedObserver : public Observer {
 public:
  // Of `run`, which must be there as long as it is observed; so must the replay.
  ReplayedObserver(std::shared_ptr<Observer> inner, Replay& replay, const Run& run)
      : inner_(std::move(inner)),
        replay_(replay),
        run_(run),
        number_(replay.enlist([inner = inner_, &run] { inner->observe(run.simulation()); })) {}

  std::int64_t next_due(const Simulation& simulation) override {
    return inner_->next_due(simulation);
  }
  bool due(const Simulation& simulation) override { return inner_->due(simulation); }
  double moment(const Simulation& simulation) override { return inner_->moment(simulation); }
  void observe(const Simulation& simulation) override {
    const Replay::Event event(replay_, number_, run_);
    inner_->observe(simulation);
  }
  std::string remark() const override { return inner_->remark(); }

 private:
  std::shared_ptr<Observer> inner_;
  Replay& replay_;
  const Run& run_;
  std::uint64_t number_;
};

}  // namespace hackle
