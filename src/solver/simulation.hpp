// SPDX-License-Identifier: MIT
// A plate being solved: state and time, integrated with velocity Verlet.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/kernel.hpp"
#include "solver/observer.hpp"
#include "solver/state.hpp"
#include "solver/threads.hpp"

namespace hackle {

// How a run is carried out; none of it changes a bit of the result.
struct Execution {
  int threads = 0;  // 0: one for each available core
  InstructionSet instruction_set = best_instruction_set();
};

class Simulation {
 public:
  // Checks plate and numerics first: throws Error (refused) with every problem found, before
  // anything large is allocated.
  Simulation(Plate plate, Numerics numerics, Execution execution = {});

  // One time step. Nothing is written, printed or checked in it.
  void step();

  // Steps until `duration` seconds more have been simulated, to the first step at or after it;
  // the time asked for is kept exactly, so that run(a); run(b) ends at the same step as run(a + b).
  // Between steps, and at the start, every observer that is due sees the state. Stops after the
  // current step with Error (interrupted) on Ctrl-C, and with Error (run_failed) when the solution
  // has diverged.
  void run(double duration, std::span<Observer* const> observers = {});

  // Goes on from another state of the same lattice: a kept one, or one prepared by hand. Its
  // acceleration is computed anew, which gives the same bits for a state that was kept.
  void restore(State state);

  const Plate& plate() const { return plate_; }
  const Numerics& numerics() const { return numerics_; }
  const Lattice& lattice() const { return lattice_; }
  const State& state() const { return state_; }
  int threads() const { return threads_.count(); }
  InstructionSet instruction_set() const { return instruction_set_; }

  double dt() const { return dt_; }                                       // s
  double time() const { return static_cast<double>(state_.step) * dt_; }  // s
  double end_time() const { return end_time_; }                           // s, asked for
  double external_work() const;                            // work done by the loads so far, J/m
  double solve_seconds() const { return solve_seconds_; }  // wall time

  // The default step for a limit: step_fraction of it, rounded down to three digits.
  static double default_step(double limit);

  // Throws Error (run_failed) unless every displacement and velocity is finite.
  void check_finite() const;

 private:
  void half_kick_and_drift();
  void count_external_work();
  void forces();
  void half_kick_rows(int row_begin, int row_end);
  void add_loads(int row_begin, int row_end);
  void advance_to(std::int64_t last_step, std::span<Observer* const> observers);

  Plate plate_;
  Numerics numerics_;
  Lattice lattice_;
  State state_;
  double dt_;
  double end_time_ = 0.0;
  double solve_seconds_ = 0.0;

  InstructionSet instruction_set_;
  ForceKernel kernel_;
  std::vector<BondClass> classes_;
  std::vector<std::size_t> loads_of_row_;  // first entry of lattice_.loads of each row, and the end
  Threads threads_;
};

}  // namespace hackle
