// SPDX-License-Identifier: MIT
// What was done with a simulation beside stepping, in order: with its state at one record, all that
// later records depend on.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

struct ChangedLoads {
  Loads loads;                           // in force from then on; see Inputs for functions
  std::vector<std::string> functions{};  // what of them is a function: "tractions 2 time"
};
struct CameToRest {
  double tolerance = 0.0;  // of RelaxOptions
};
struct LoadedSlowly {
  double end = 0.0;  // s, the time to which it was to go
  int increments = 1;
  double tolerance = 0.0;
};
struct EndedSlowly {
  int looks = 0;  // how often observers saw it: at its beginning and after each increment
};
struct Recorded {};  // a record taken in the middle of slow loading
struct NotNoted {};  // more than a journal can hold; the loads that are then in force follow

struct Deed {
  std::int64_t step = 0;  // done before it
  int look = -1;          // the look of slow loading at which it was done, from 0; -1: outside
  std::variant<ChangedLoads, CameToRest, LoadedSlowly, EndedSlowly, Recorded, NotNoted> what;
};

// Of the deeds between two records.
class Journal {
 public:
  // Each is told after it has been done, but slow loading when it begins.
  void changed_loads(const Simulation& simulation);
  void came_to_rest(const Simulation& simulation, double tolerance);
  void loads_slowly(const Simulation& simulation, const LoadedSlowly& loading);
  void looked() { ++look_; }  // at slow loading, before anybody else does
  void ended_slowly(const Simulation& simulation);

  // Says that more was done than is noted.
  void lose_track(const Simulation& simulation);

  // Forgets what was done before the present state, but not that it is being loaded slowly.
  void begin();
  // Returns the deeds since the last record as JSON text, for a record taken now; "" if there are
  // none. They are then forgotten.
  std::string take(const Simulation& simulation);
  // Returns the same without forgetting it, for another program, whose journal resumes from it.
  // Slow loading is not resumed. Throws std::exception for another text.
  std::string pending() const;
  void resume(const std::string& pending);

 private:
  void add(const Simulation& simulation, std::string deed);

  std::vector<std::string> deeds_;  // in JSON
  std::size_t bytes_ = 0;           // of deeds_
  bool full_ = false;
  std::string slow_;  // the deed that is going on
  int look_ = -1;
};

// Reads what take() returned. Throws std::exception, or Error (files), for another text.
std::vector<Deed> deeds_in(const std::string& text);

// Names everything in a text of inputs_of() that is a function of a script and acts in a run:
// "tractions 2 time". Throws std::exception for another text.
std::vector<std::string> functions_in(const std::string& inputs);

}  // namespace hackle
