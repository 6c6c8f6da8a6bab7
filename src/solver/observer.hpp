// SPDX-License-Identifier: MIT
// Observers see a simulation between its steps.
#pragma once

#include <cstdint>
#include <string>

namespace hackle {

class Simulation;

class Observer {
 public:
  virtual ~Observer() = default;
  // The first step at which it may be due; it is asked no earlier. Asked itself at the beginning of
  // a run and whenever that step has come. By default it may be due at any.
  virtual std::int64_t next_due(const Simulation&) { return 0; }
  // Whether it wants to see the state as it is now. Must be cheap.
  virtual bool due(const Simulation& simulation) = 0;
  // The time at which it wants to see it when it is due, s: no more than a step ago.
  virtual double moment(const Simulation& simulation);
  virtual void observe(const Simulation& simulation) = 0;
  // Whether it looks at nodes then: for others, ranks need not gather those of the whole plate.
  virtual bool looks_at_nodes() const { return true; }
  // What a user should know about when it looks on; may be empty.
  virtual std::string remark() const { return {}; }
};

}  // namespace hackle
