// SPDX-License-Identifier: MIT
// Records, without computing, what a script does to a simulation, and judges what may break.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "scene/forecast.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class Prospect {
 public:
  // Call this while the simulation is at the beginning of the episode, with the loads that act
  // until `end`, s.
  void run(const Simulation& simulation, double end);
  void load_slowly(const Simulation& simulation, double end, int increments);
  void relax(const Simulation& simulation);
  // Applies these loads from now on; the stress of earlier loads stays in the plate.
  void exchange_loads(const Simulation& simulation, const Loads& loads);
  // Time passes, and nothing else does: run() and load_slowly() with a simulation that arrives at
  // once. Throws Error (refused) for more steps in all than a script can mean.
  void arrive(Simulation& simulation);
  void arrive_slowly(Simulation& simulation, double duration, int increments);

  // Notes that the script has read results, which do not exist: its further actions may depend on
  // them.
  void look() { looked_ = true; }
  bool looked() const { return looked_; }
  // Notes something that cannot be judged without computing, as a clause.
  void doubt(std::string why) { doubts_.insert(std::move(why)); }

  std::int64_t steps() const { return steps_; }
  int increments() const { return increments_; }
  bool rests() const { return rests_; }  // static equilibrium is requested
  // Returns the forecast of the episode in which most may break; for a simulation without a run, of
  // its present loads.
  Forecast worst(const Simulation& simulation) const;
  const std::set<std::string>& doubts() const { return doubts_; }

 private:
  void judge(const Simulation& simulation, double end, bool slow);
  void go_on();

  std::int64_t steps_ = 0;
  int increments_ = 0;
  double since_ = 0.0;   // s, when the supports were applied
  double acted_ = 0.0;   // Pa, largest stress by the loads
  double stored_ = 0.0;  // Pa, largest stress by earlier loads
  bool looked_ = false;
  bool rests_ = false;
  bool judged_ = false;
  Forecast worst_;
  std::set<std::string> doubts_;
};

}  // namespace hackle
