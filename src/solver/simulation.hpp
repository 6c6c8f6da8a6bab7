// SPDX-License-Identifier: MIT
// A plate being solved: state and time, integrated with velocity Verlet.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/engine.hpp"
#include "solver/loading.hpp"
#include "solver/observer.hpp"
#include "solver/quasistatic.hpp"
#include "solver/state.hpp"
#include "solver/thermal_strain.hpp"
#include "solver/threads.hpp"

namespace hackle {

inline constexpr double max_steps = 1e15;  // of a run; whole numbers up to there are exact

// How a run is carried out; none of it changes a bit of the result.
struct Execution {
  int threads = 0;  // 0: one for each available core
  InstructionSet instruction_set = best_instruction_set();
};

// Wall time of parts of a step that not every scene has, s.
struct StepSeconds {
  double damping = 0.0;
  double heat = 0.0;
  LoadSeconds loads;

  double sum() const { return damping + heat + loads.all; }
};

// A state as it was once, with what belongs to it in a picture.
struct Snapshot {
  State state;                         // step == start: u and v belong to the same time
  std::vector<double> thermal_strain;  // by Grid::index; empty where nothing was heated
  std::vector<Impactor> impactors;     // one for each disc of the state
};

class Simulation {
 public:
  // Checks plate and numerics first: throws Error (refused) with every problem found, before
  // anything large is allocated. `strength` is the critical stretch of every node over s0, above 0,
  // by Grid::index, or nothing, when the scatter of
  // the plate holds: a bond breaks by the weaker of its ends.
  Simulation(Plate plate, Numerics numerics, Execution execution = {},
             std::vector<float> strength = {});

  // One time step. Nothing is written, printed or checked in it.
  void step();

  // Steps until `duration` seconds more have been simulated, to the first step at or after it; the
  // time asked for is kept exactly, so that run(a); run(b) ends at the same step as run(a + b).
  // Functions of time in the loads are asked before the first of these steps, and may throw.
  // Between steps, and at the start, every observer that is due sees the state. Stops after the
  // current step with Error (interrupted) on Ctrl-C, and with Error (run_failed) when the solution
  // has diverged: it holds values that are no numbers, or a thousand times the energy that was ever
  // put in.
  void run(double duration, std::span<Observer* const> observers = {});

  // run() in pieces: aim() adds to the time to be reached, go_on() goes there, or returns when an
  // observer breaks off and may be called again. Each throws what run() throws; the aim stays.
  void aim(double duration);
  void go_on(std::span<Observer* const> observers = {});
  bool has_arrived() const { return state_.step >= last_step_; }
  std::int64_t last_step() const { return last_step_; }  // of the current aim
  // For observers: go_on() returns after this step, load_slowly() after this increment.
  void break_off() { break_off_ = true; }
  // Cancels the remaining run; from an observer, after the current step.
  void stop();

  // Brings the plate to rest where everything that acts at the present time is in balance, without
  // breaking a bond: what runs on from there starts from a plate under load. Loads that have come
  // since the plate last stood still do the work of growing slowly (StaticWork); what it had too
  // much, in motion and out of balance, is released. Throws Error (refused) for pieces that loads
  // push and nothing holds, and for impactors; Error (run_failed) when no equilibrium is found,
  // Error (interrupted) on Ctrl-C: then nothing has changed.
  RelaxResult relax(const RelaxOptions& options = {});

  // Goes through `duration` seconds of the amplitudes of all loads slowly, without a step:
  // increments may be shorter than one. It begins now and ends `duration` after the time that was
  // asked for before, which a run may have passed by part of a step. At the end of each of equal
  // increments of time, exactly then, the plate is brought to rest (see relax); while bonds are
  // then stretched too far, the worst of them break and it is brought to rest again. Observers see
  // the beginning and the state after each increment, when they are due, and may change loads
  // there. Ends early when the plate comes apart, which is a result, or when an observer breaks
  // off. Throws what relax throws, with the state after the last increment that was completed.
  QuasistaticResult load_slowly(const QuasistaticOptions& options,
                                std::span<Observer* const> observers = {});

  // Replaces all loads from now on; an observer may do so between two steps. Throws Error (refused)
  // with every problem found, a step that is too long for them among them.
  void set_loads(Loads loads);

  // Continues from another state of the same lattice: a kept one, which gives the same bits, or one
  // prepared by hand.
  void restore(State state);

  // Shows a recorded state with its discs. Requires a simulation built without loads; step() must
  // not be called afterwards.
  void show(Snapshot snapshot);

  const Plate& plate() const { return plate_; }
  const Numerics& numerics() const { return numerics_; }
  const Lattice& lattice() const { return lattice_; }
  const State& state() const { return state_; }
  const Loading& loading() const { return loading_; }
  // Of every node, now, by Grid::index; empty when nothing is heated.
  const std::vector<double>& thermal_strain() const { return heat_.values(); }
  int threads() const { return threads_.count(); }
  InstructionSet instruction_set() const { return instruction_set_; }

  double dt() const { return dt_; }                                                      // s
  double time() const { return time_at(state_.step); }                                   // s
  double time_at(std::int64_t step) const { return state_.clock.time(step, 0.0, dt_); }  // s
  double end_time() const { return end_time_; }  // s, asked for
  double external_work() const;                  // done by loads, supports and heat so far, J/m
  double damped_energy() const;                  // taken by damping so far, J/m
  double released_energy() const;  // given off by jumps and on the way to rest so far, J/m
  double kinetic_energy() const;   // now, J/m
  // Stored in contacts now, or lost there when bonds broke; less what they store since the plate
  // came to rest, which took no notice of them. J/m.
  double contact_energy() const;
  Vec2 displacement(int i, int j) const;  // m
  std::vector<Vec2> velocities() const;   // m/s, now, by Grid::index
  // Whether the bond of node (i, j) to (i + column, j + row) holds.
  bool holds(int i, int j, int column, int row) const;
  // The bonds that broke in the last step, or increment of slow loading.
  const std::vector<BrokenBond>& broken_bonds() const;
  // Tile-steps so far by the path they took.
  const PathCounts& path_counts() const;
  // When a run in f32 went over to f64, s: its displacements had grown too large.
  std::optional<double> widened_at() const { return widened_at_; }
  // Bytes of state, lattice and engine that grow with the plate.
  std::size_t bytes() const;
  double solve_seconds() const { return solve_seconds_; }  // wall time of all steps
  // The parts spent in damping, heat and varying loads; the rest is the kernel's.
  const StepSeconds& step_seconds() const { return step_seconds_; }

  // The default step for a limit: step_fraction of it, rounded down to three digits.
  static double default_step(double limit);
  // The same, and short enough for every disc (see longest_step_of_impact).
  static double default_step(const Plate& plate, const Lattice& lattice);

  // Throws Error (run_failed) unless every displacement and velocity is a number, and one that the
  // single precision of fields can hold.
  void check_finite() const;

 private:
  EngineOptions options() const;
  void start();
  double energy_of_state() const;  // of motion and of bonds, in units of the state's work
  void prepare();
  double damp_motion();
  void take_loads();
  void take_heat();
  void count_heat_work();
  // In bonds and contacts, in units of the state's work.
  double heat_work_between(const std::vector<double>& before,
                           const std::vector<double>& after) const;
  void count_external_work();
  double work_of_half_step() const;             // the ledger's, in units of the state's
  double prescribed_work_of_half_step() const;  // likewise
  double lost_in_half_step() const;             // likewise
  void change_damping(double rate);
  std::vector<Vec2> accelerations() const;  // lattice units, by Grid::index, as if nothing were led
  double energy_unit() const;               // J/m
  void keep_f32_exact();
  void check_statics(const RelaxOptions& options) const;
  double check_motion() const;
  void check_energy(double motion);
  [[noreturn]] void throw_diverged(int i, int j) const;
  void look_after_step(std::span<Observer* const> observers);
  // What acts on the plate before it is brought to rest.
  struct Departure {
    std::vector<LoadedNode> loads;  // which did their work up to here
    std::vector<double> heat;       // thermal strain
  };
  Departure depart();
  Equilibrium go_to_rest(const Departure& from, StaticEquilibrium& equilibrium,
                         const RelaxOptions& options);
  Equilibrium settle(StaticEquilibrium& equilibrium, const RelaxOptions& options);
  void load_to(double end, const QuasistaticOptions& options, QuasistaticResult& result);
  void break_and_settle(double end, const QuasistaticOptions& options, QuasistaticResult& result,
                        std::vector<BrokenBond>& broken_bonds);
  void let_look(std::span<Observer* const> observers) const;
  void put(const NodeVectors& u);
  void come_to_rest(std::vector<BrokenBond> broken_bonds);

  Plate plate_;
  Numerics numerics_;
  Lattice lattice_;
  State state_;
  double dt_;
  Loading loading_;
  ThermalStrain heat_;
  std::vector<LoadedNode> borne_;  // loads under which the plate last came to rest
  double end_time_ = 0.0;
  std::int64_t last_step_ = 0;  // of the run that is under way, or was
  bool break_off_ = false;
  double solve_seconds_ = 0.0;
  StepSeconds step_seconds_;
  std::optional<double> widened_at_;
  double max_energy_ = 0.0;  // the most energy put in so far, in units of the state's work

  InstructionSet instruction_set_;
  Threads threads_;
  // mutable: const queries use its scratch memory.
  mutable std::variant<Engine<double>, Engine<float>> engine_;
};

}  // namespace hackle
