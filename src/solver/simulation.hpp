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
  // anything large is allocated. `strength` is the critical stretch of every node over s0, above 0,
  // by Grid::index, or nothing: a bond breaks by the weaker of its ends.
  Simulation(Plate plate, Numerics numerics, Execution execution = {},
             std::vector<float> strength = {});

  // One time step. Nothing is written, printed or checked in it.
  void step();

  // Steps until `duration` seconds more have been simulated, to the first step at or after it;
  // the time asked for is kept exactly, so that run(a); run(b) ends at the same step as run(a + b).
  // Between steps, and at the start, every observer that is due sees the state. Stops after the
  // current step with Error (interrupted) on Ctrl-C, and with Error (run_failed) when the solution
  // has diverged.
  void run(double duration, std::span<Observer* const> observers = {});

  // Goes on from another state of the same lattice: a kept one, which gives the same bits, or one
  // prepared by hand.
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
  double external_work() const;           // work done by the loads so far, J/m
  Vec2 displacement(int i, int j) const;  // m
  std::vector<Vec2> velocities() const;   // m/s, now, by Grid::index
  // Whether the bond of node (i, j) to (i + column, j + row) holds.
  bool holds(int i, int j, int column, int row) const;
  // Tile-steps so far by the path they took.
  const PathCounts& path_counts() const;
  // When a run in f32 went over to f64, s: its displacements had grown too large.
  std::optional<double> widened_at() const { return widened_at_; }
  // Bytes of state, lattice and engine that grow with the plate.
  std::size_t bytes() const;
  double solve_seconds() const { return solve_seconds_; }  // wall time

  // The default step for a limit: step_fraction of it, rounded down to three digits.
  static double default_step(double limit);

  // Throws Error (run_failed) unless every displacement and velocity is a number, and one that the
  // single precision of fields can hold.
  void check_finite() const;

 private:
  EngineOptions options() const;
  void prepare();
  void count_external_work();
  void keep_f32_exact();
  void advance_to(std::int64_t last_step, std::span<Observer* const> observers);

  Plate plate_;
  Numerics numerics_;
  Lattice lattice_;
  State state_;
  double dt_;
  double end_time_ = 0.0;
  double solve_seconds_ = 0.0;
  std::optional<double> widened_at_;

  InstructionSet instruction_set_;
  Threads threads_;
  // Its scratch memory serves questions about the state, too.
  mutable std::variant<Engine<double>, Engine<float>> engine_;
};

}  // namespace hackle
