// SPDX-License-Identifier: MIT
// What a script lets happen to a simulation, noted while nothing is computed, and judged.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "scene/forecast.hpp"
#include "solver/simulation.hpp"

namespace hackle {

class Prospect {
 public:
  // To be called while the simulation is at the beginning of the episode, under its loads, which
  // are in force until `end`, s.
  void run(const Simulation& simulation, double end);
  void load_slowly(const Simulation& simulation, double end, int increments);
  void relax(const Simulation& simulation);
  // These loads act from now on; what was put into the plate is still in it.
  void exchange_loads(const Simulation& simulation, const Loads& loads);
  // Time passes, and nothing else does: run() and load_slowly() with a simulation that arrives at
  // once. Throws Error (refused) for more steps in all than a script can mean.
  void arrive(Simulation& simulation);
  void arrive_slowly(Simulation& simulation, double duration, int increments);

  // The script has looked at results, which are not there: what it does from now on may depend on
  // them.
  void look() { looked_ = true; }
  bool looked() const { return looked_; }
  // Something that cannot be judged without computing, as a half-sentence.
  void doubt(std::string why) { doubts_.insert(std::move(why)); }

  std::int64_t steps() const { return steps_; }
  int increments() const { return increments_; }
  bool rests() const { return rests_; }  // the plate is to come to rest
  // Of the episode in which most may break; of a simulation that is never computed, of its loads as
  // they are.
  Forecast worst(const Simulation& simulation) const;
  const std::set<std::string>& doubts() const { return doubts_; }

 private:
  void judge(const Simulation& simulation, double end, bool slow);
  void go_on();

  std::int64_t steps_ = 0;
  int increments_ = 0;
  double since_ = 0.0;   // s, when the supports were put on
  double acted_ = 0.0;   // Pa, the most that the loads did
  double stored_ = 0.0;  // Pa, the most that others had done before
  bool looked_ = false;
  bool rests_ = false;
  bool judged_ = false;
  Forecast worst_;
  std::set<std::string> doubts_;
};

}  // namespace hackle
