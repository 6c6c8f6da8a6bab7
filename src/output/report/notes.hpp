// SPDX-License-Identifier: MIT
// The remarks on a run: each is said once, as soon as it is known.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class Notes {
 public:
  explicit Notes(Talk talk) : talk_(talk) {}

  // A remark of somebody else; none if it is empty.
  void add(const std::string& remark);
  // On a plate that has just been set up.
  void begin(const Simulation& simulation);
  // On loads that have been exchanged; `before` is the thermal strain under the former ones.
  void exchange_loads(const Simulation& simulation, const std::vector<double>& before);
  // On loads, before they act until the simulation arrives. Evaluates functions of time; throws
  // Error (interrupted) alone.
  void look_at_loads(const Simulation& simulation);
  // On a ledger that does not close (see ledger_remark), once per state.
  void judge(const Simulation& simulation);
  // What was before is judged elsewhere.
  void begin_judging_at(const Simulation& simulation);

  const std::vector<std::string>& all() const { return all_; }

 private:
  using Situation = std::array<double, 3>;  // step, time and work
  void say(const std::vector<std::string>& remarks);
  void say_at_once(const std::vector<std::string>& remarks);

  Talk talk_;
  std::vector<std::string> all_;
  Situation judged_{0.0, 0.0, 0.0};
  bool fresh_loads_ = true;  // they have not been examined
  bool at_once_ = false;     // some load was remarked on for breaking bonds at once
};

}  // namespace hackle
