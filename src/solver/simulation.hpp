// SPDX-License-Identifier: MIT
// A plate being solved: runs, and states at rest, between which observers look on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solver/aim.hpp"
#include "solver/moving_plate.hpp"
#include "solver/observer.hpp"
#include "solver/snapshot.hpp"
#include "solver/statics/rest.hpp"
#include "solver/time_point.hpp"
#include "solver/view.hpp"

namespace hackle {

class Simulation {
 public:
  // Checks plate and numerics first: throws Error (refused) with every problem, before anything
  // large is allocated. `strength` is the critical stretch of every node over s0, above 0, by
  // Grid::index; if empty, the scatter of the plate applies: a bond breaks at the smaller value of
  // its ends.
  Simulation(Plate plate, Numerics numerics, Execution execution = {},
             std::vector<float> strength = {});

  // Goes on from a snapshot of a simulation of this plate, with the loads of that moment, with the
  // same bits, for any execution. Throws what the constructor throws, and Error (refused) for a
  // state of another lattice or with values that are not finite.
  static Simulation resumed(Plate plate, Numerics numerics, Snapshot snapshot,
                            Execution execution = {});
  Snapshot snapshot() const;

  // Makes one time step. Nothing is written, printed or checked in it.
  void step();

  // Runs until `duration` seconds more have been simulated, to the first step at or after that
  // time; the requested time is kept exactly, so that run(a); run(b) ends at the same step as run(a
  // + b), and the plate is seen as it is then (see Instant). Functions of time in the loads are
  // evaluated before the first of these steps, and may throw. Between steps, and at the start,
  // every observer that is due sees the state. Stops after the current step with Error
  // (interrupted) on Ctrl-C, and with Error (run_failed) if the solution has diverged: if it
  // contains values that are not finite, or a thousand times the energy ever supplied.
  void run(double duration, std::span<Observer* const> observers = {});

  // run() in parts: aim() adds to the time to be reached, go_on() runs to it, or returns if an
  // observer breaks off, and may be called again. Each throws what run() throws; the aim stays.
  void aim(double duration);
  void go_on(std::span<Observer* const> observers = {});
  bool has_arrived() const { return state().step >= aim_.last_step; }
  std::int64_t last_step() const { return aim_.last_step; }  // of the current aim
  TimePoint time_point() const { return {state().step, state().clock, aim_, time()}; }
  // Claims to be at that point, with the plate as it is: for whoever runs a script again up to
  // where a snapshot will take its place.
  void pretend(const TimePoint& point);
  // For observers: makes go_on() return after this step, load_slowly() after this increment.
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
  // off. Throws what relax throws, with the state after the last increment that was completed. A
  // simulation that was resumed from a snapshot within such a loading may go on with it.
  QuasistaticResult load_slowly(const QuasistaticOptions& options,
                                std::span<Observer* const> observers = {});

  // Replaces all loads from now on; an observer may call it between two steps. Throws Error
  // (refused) with every problem, including a step that is too long for them.
  void set_loads(Loads loads);

  // Continues from another state of the same lattice: a stored one, which gives the same bits, or
  // one prepared by hand.
  void restore(State state);

  const Plate& plate() const { return plate_.plate(); }
  const Numerics& numerics() const { return plate_.numerics(); }
  const Lattice& lattice() const { return plate_.lattice(); }
  const State& state() const { return plate_.state(); }
  // What acts in the step to come.
  const Actions& actions() const { return plate_.terms().actions(); }
  // Returns the present thermal strain of every node, by Grid::index; empty if nothing is heated.
  const std::vector<double>& thermal_strain() const { return plate_.thermal_strain(); }
  int threads() const { return plate_.threads().count(); }
  InstructionSet instruction_set() const { return plate_.instruction_set(); }

  // What can be seen of it now; holds until the next step.
  View view() const { return View(plate_, aim_.end_time, seen_at_); }
  operator View() const { return view(); }  // NOLINT: whatever takes a view takes a simulation

  double dt() const { return plate_.dt(); }                                                // s
  double time() const { return seen_at_ ? seen_at_->time() : plate_.time(); }              // s
  double time_of_step() const { return plate_.time(); }                                    // s
  double time_at(std::int64_t step) const { return state().clock.time(step, 0.0, dt()); }  // s
  double end_time() const { return aim_.end_time; }                                        // s
  Ledger ledger() const { return plate_.ledger(); }                                        // J/m
  double kinetic_energy() const { return view().kinetic_energy(); }            // now, J/m
  Vec2 displacement(int i, int j) const { return view().displacement(i, j); }  // m
  // Returns the forces of the plate on impactors, rollers and platens, now.
  std::vector<Reaction> reactions() const { return plate_.reactions(); }
  std::vector<Vec2> velocities() const { return view().velocities(); }  // m/s, by Grid::index
  // Returns whether the bond of node (i, j) to (i + column, j + row) is intact.
  bool holds(int i, int j, int column, int row) const { return view().holds(i, j, column, row); }
  // Returns the bonds that broke in the last step, or increment of quasi-static loading.
  const std::vector<BrokenBond>& broken_bonds() const { return plate_.stepper().broken_bonds(); }
  // Returns tile-steps so far by path.
  const PathCounts& path_counts() const { return plate_.stepper().path_counts(); }
  // Returns when an f32 run changed to f64, s: its displacements had grown too large.
  std::optional<double> widened_at() const { return plate_.widened_at(); }
  // Bytes of state, lattice and stepper that grow with the plate.
  std::size_t bytes() const { return plate_.bytes(); }
  double solve_seconds() const { return solve_seconds_; }  // wall time of all steps
  // The parts that terms of the scene took; the rest is the stepper's.
  std::vector<TermSeconds> term_seconds() const { return plate_.terms().seconds(); }

  // Throws Error (run_failed) unless every displacement and velocity is finite, also in the single
  // precision of fields.
  void check_finite() const { hackle::check_finite(view()); }

 private:
  // What observers want, while a run lasts.
  class Audience;

  // step() on the rows of this rank.
  void advance();
  void look_after_step(Audience& audience);
  void throw_if_to_leave();
  void begin_anew();
  // Lets the plate be seen at a time between the last step and the one before; at any other, and
  // where it has just stood still, at the last step.
  void show(double time);

  MovingPlate plate_;
  Aim aim_;
  std::optional<Instant> seen_at_;  // none: the last step
  bool break_off_ = false;
  std::optional<SlowCourse> course_;  // of the last slow loading
  double solve_seconds_ = 0.0;
  Divergence divergence_;
};

}  // namespace hackle
