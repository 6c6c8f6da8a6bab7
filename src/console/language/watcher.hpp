// SPDX-License-Identifier: MIT
// Calls a function of a script between the steps of a run.
#pragma once

#include <cstdint>
#include <vector>

#include "console/lua/lua_function.hpp"
#include "measure/crack_graph.hpp"
#include "output/files/schedule.hpp"
#include "scene/loads.hpp"
#include "solver/observer.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Calls a function with the time, s.
void call(const LuaFunction& function, const Simulation& simulation);

class Watcher : public Observer {
 public:
  explicit Watcher(LuaFunction function) : function_(std::move(function)) {}

  void observe(const Simulation& simulation) override { call(function_, simulation); }

 private:
  LuaFunction function_;
};

// Calls at equal intervals of simulated time, including the present.
class Ticker : public ScheduledObserver {
 public:
  Ticker(LuaFunction function, double every, const Simulation& simulation)
      : ScheduledObserver(Schedule("on", every, simulation)), function_(std::move(function)) {}

 private:
  void look(const Simulation& simulation) override { call(function_, simulation); }

  LuaFunction function_;
};

// Calls once, when the damage of a node in the area first exceeds a value; at once if it already
// does.
class DamageAlarm : public Watcher {
 public:
  DamageAlarm(LuaFunction function, const Region& area, double above, const Simulation& simulation);

  bool due(const Simulation& simulation) override;
  void observe(const Simulation& simulation) override {
    rung_ = true;
    Watcher::observe(simulation);
  }

 private:
  bool is_damaged(const Simulation& simulation, int i, int j) const;

  std::vector<std::uint8_t> area_;  // by Grid::index
  double above_;
  bool rung_ = false;
  bool at_start_ = true;  // no state has been examined
};

// Calls once, when the next bond breaks.
class BreakAlarm : public Watcher {
 public:
  BreakAlarm(LuaFunction function, const Simulation& simulation)
      : Watcher(std::move(function)), start_(simulation.time()) {}

  bool due(const Simulation& simulation) override;
  void observe(const Simulation& simulation) override {
    rung_ = true;
    Watcher::observe(simulation);
  }

 private:
  bool rung_ = false;
  double start_;  // s
};

// Calls when it sees that something of a kind has happened to the cracks since it was set: a fork
// is one only when its branches are apart.
class CrackAlarm : public Watcher {
 public:
  CrackAlarm(LuaFunction function, CrackEventKind kind, const Simulation& simulation);

  // Looks at the cracks when they have grown by about a horizon, or may have come to rest.
  bool due(const Simulation& simulation) override;

 private:
  bool is_new(const CrackEvent& event, double horizon) const;
  bool is_time_to_look(const Simulation& simulation) const;

  CrackEventKind kind_;
  CrackGrowth growth_;
  std::size_t seen_nodes_ = 0;
  double seen_time_;
  std::int64_t seen_step_;
  std::vector<CrackEvent> known_;
};

}  // namespace hackle
