// SPDX-License-Identifier: MIT
// A plate on its lattice in time: its state, what acts on it, and the stepper that moves it. Knows
// steps, and nothing of how long a run is or who looks on.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/machine.hpp"
#include "solver/cpu/instruction_set.hpp"
#include "solver/slab.hpp"
#include "solver/terms.hpp"

namespace hackle {

// The execution of a run; it changes no bit of the result.
struct Execution {
  int threads = 0;  // 0: one per available core
  int thread_count() const { return threads > 0 ? threads : available_cores(); }
  InstructionSet instruction_set = best_instruction_set();
  Ranks* ranks = nullptr;  // that solve each plate together; nullptr: this process does, alone
};

class MovingPlate {
 public:
  // See Simulation.
  MovingPlate(Plate plate, const Numerics& numerics, const Execution& execution,
              std::vector<float> strength);

  // Makes one time step. Nothing is written, printed or checked in it. Where there are ranks, each
  // knows only its own rows afterwards, until complete().
  void step();
  // Gives every rank the whole plate: what follows may then look at all of it.
  void complete();
  // Whether it is so for any rank; all of them ask.
  bool holds_for_any(bool own) const {
    return slab().is_whole() ? own : slab().ranks->any(own ? 1 : 0) != 0;
  }
  // The rows that this rank moves.
  const Slab& slab() const { return stepper_->slab(); }
  // Functions of time are asked now for all steps from the present one up to `last`.
  void tabulate(std::int64_t last) { terms_.tabulate(state_.clock, state_.step, last + 1, dt_); }
  // Replaces all loads from now on, in a run that is to go on to `last_step`. See Simulation.
  void set_loads(Loads loads, std::int64_t last_step);
  void restore(State state);
  // Goes on as this plate, which differs in its loads and in how it began, from a state of it.
  // `widened_at` as below.
  void resume(Plate plate, State state, std::optional<double> widened_at);

  // Finds what acts at the time of the state; to be called when it is not the one that step() left.
  void prepare();
  // Finds what acts on a plate that stands still, see Term::halt. prepare() must follow.
  void halt(double passed) { terms_.halt(around(), state_, passed); }
  // Books in the state what the ledger adds to it: the half step that is open has been done.
  void close_ledger();
  // The plate stands still from now on, under what acts since halt(), and these bonds broke on the
  // way. Contacts took no part: what is stored in them now and was not before came from nowhere.
  void come_to_rest(std::vector<BrokenBond> broken_bonds);
  // The bonds that broke in the last step; known where that step was made elsewhere.
  void note_broken_bonds(std::vector<BrokenBond> broken_bonds);
  // The loads under which it last came to rest.
  const std::vector<LoadedNode>& borne() const { return borne_; }
  void set_borne(std::vector<LoadedNode> borne) { borne_ = std::move(borne); }

  const Plate& plate() const { return plate_; }
  const Numerics& numerics() const { return numerics_; }
  const Lattice& lattice() const { return lattice_; }
  const State& state() const { return state_; }
  State& state() { return state_; }
  const Terms& terms() const { return terms_; }
  const Stepper& stepper() const { return *stepper_; }
  const Threads& threads() const { return threads_; }
  InstructionSet instruction_set() const { return instruction_set_; }
  const std::vector<double>& thermal_strain() const { return terms_.thermal_strain(); }
  double dt() const { return dt_; }                                         // s
  double time() const { return state_.clock.time(state_.step, 0.0, dt_); }  // s
  std::optional<double> widened_at() const { return widened_at_; }          // s
  double energy_unit() const { return around().energy_unit(); }             // J/m

  Ledger ledger() const { return energy_unit() * terms_.ledger(around(), state_); }  // J/m
  // Of motion, bonds and contacts, as if u and v belonged to the same time; in energy_unit().
  double energy() const;
  // The forces of the plate on impactors, rollers and platens, now.
  std::vector<Reaction> reactions() const { return terms_.reactions(around(), state_); }
  std::vector<Vec2> velocities() const;  // m/s, now, by Grid::index
  // The same of one node, to rounding. Forces are not linearised (fidelity), and a bond that the
  // next step breaks still pulls.
  Vec2 velocity(int i, int j) const;
  std::size_t bytes() const;  // that grow with the plate

 private:
  Surroundings around() const { return around(terms_, undivided); }
  Surroundings around(const Terms& terms, const Slab& slab) const {
    return {lattice_, dt_, threads_, *stepper_, terms.list(), terms.thermal_strain(), slab};
  }
  Cloned<Stepper> make_stepper(Precision precision) const;
  Terms terms_for(const Plate& plate, std::int64_t last_step);
  double grid_speed() const { return lattice_.grid.dx / dt_; }  // m/s, of a spacing per step
  Vec2 caught_up(const Vec2& v, const Vec2& acceleration) const;
  Vec2 acceleration(int i, int j) const;
  double heat_work_of_change(const Terms& next) const;
  double work_of_half_step() const;  // in energy_unit(), here as below
  double lost_in_half_step() const;
  void change_damping(double rate);
  void keep_f32_exact();

  Plate plate_;
  Numerics numerics_;
  Lattice lattice_;
  State state_;
  double dt_;
  Terms terms_;
  std::vector<LoadedNode> borne_;
  std::optional<double> widened_at_;

  Ranks* ranks_;          // nullptr: alone
  bool complete_ = true;  // this rank knows more than its own rows
  InstructionSet instruction_set_;
  Threads threads_;
  mutable Cloned<Stepper> stepper_;  // const queries use its scratch memory
};

}  // namespace hackle
