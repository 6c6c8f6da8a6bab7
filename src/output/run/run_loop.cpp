// SPDX-License-Identifier: MIT
#include "output/run/run_loop.hpp"

#include "base/error.hpp"

namespace hackle {

void RunLoop::refuse_while_running() const {
  if (activity_ == Activity::stepping)
    throw Error(ErrorKind::refused, "the simulation is running",
                "functions of time may not run it or change it");
  if (activity_ == Activity::watched)
    throw Error(ErrorKind::refused, "the simulation is running",
                "between two steps its loads may be changed, or s:stop() ends the run");
}

void RunLoop::watch(std::shared_ptr<Observer> watcher) {
  refuse_while_running();
  watchers_.emplace_back(std::move(watcher), activity_);
}

std::vector<Observer*> RunLoop::with_watchers(std::vector<Observer*> observers) {
  for (Watched& watcher : watchers_) observers.push_back(&watcher);
  if (keeper_) observers.push_back(&*keeper_);
  return observers;
}

void RunLoop::go_on(Simulation& simulation, std::vector<Observer*> observers) {
  const Mark busy = mark_busy();
  try {
    keeping(simulation, [&] { simulation.go_on(observers); });
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted)
      interrupted_at_ = simulation.state().step;
    else
      simulation.stop();
    throw;
  }
}

}  // namespace hackle
