// SPDX-License-Identifier: MIT
// Observers look at a simulation between its steps.
#pragma once

namespace hackle {

class Simulation;

class Observer {
 public:
  virtual ~Observer() = default;
  // Whether it wants to see the state as it is now. Asked after every step; must be cheap.
  virtual bool due(const Simulation& simulation) = 0;
  virtual void observe(const Simulation& simulation) = 0;
};

}  // namespace hackle
