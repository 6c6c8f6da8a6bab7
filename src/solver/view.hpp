// SPDX-License-Identifier: MIT
// What can be seen of a plate at a moment: of one that is being solved, and of one that was
// recorded, which needs neither an engine nor what acts on the plate.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/instant.hpp"
#include "solver/ledger.hpp"
#include "solver/state.hpp"

namespace hackle {

class MovingPlate;

class View {
 public:
  // Everything must outlive the view. The state is at its start: u and v belong to the same time.
  // `thermal_strain` is by Grid::index; empty where nothing is heated.
  View(const Plate& plate, const Numerics& numerics, const Lattice& lattice, double dt,
       const State& state, const std::vector<double>& thermal_strain)
      : plate_(&plate),
        numerics_(&numerics),
        lattice_(&lattice),
        dt_(dt),
        state_(&state),
        thermal_strain_(&thermal_strain) {}
  // Of a plate that moves, on its way to `until`, s, as it is at an instant; holds until its next
  // step.
  explicit View(const MovingPlate& moving, double until = 0.0, std::optional<Instant> instant = {});

  const Plate& plate() const { return *plate_; }
  const Numerics& numerics() const { return *numerics_; }
  const Lattice& lattice() const { return *lattice_; }
  // Between steps: the one that is seen then.
  const State& state() const { return instant_ ? instant_->seen(*state_) : *state_; }
  // By Grid::index; empty if nothing is heated.
  const std::vector<double>& thermal_strain() const { return *thermal_strain_; }

  double dt() const { return dt_; }  // s
  double time() const {              // s
    return instant_ ? instant_->time() : state_->clock.time(state_->step, 0.0, dt_);
  }
  // The same plate at its last step: what is counted, such as energies, belongs together there.
  View at_step() const;
  // The time to which the plate is on its way, s; its own where nothing was asked for.
  double until() const { return std::max(until_, time()); }
  double energy_unit() const;             // J/m, of the state's ledger: rho dx^4/dt^2
  Ledger ledger() const;                  // J/m
  double kinetic_energy() const;          // J/m
  Vec2 displacement(int i, int j) const;  // m
  std::vector<Vec2> velocities() const;   // m/s, by Grid::index
  // Returns the same of one node, m/s, without a look at any other node's bonds.
  Vec2 velocity(int i, int j) const;
  // Returns whether the bond of node (i, j) to (i + column, j + row) is intact.
  bool holds(int i, int j, int column, int row) const;

 private:
  double behind() const { return instant_ ? instant_->behind() : 0.0; }
  Vec2 half_step_velocity(int i, int j) const { return lattice_->grid.dx / dt_ * state_->v(i, j); }
  // Takes a velocity at the last step to the instant.
  Vec2 velocity_then(const Vec2& now, int i, int j) const;

  const Plate* plate_;
  const Numerics* numerics_;
  const Lattice* lattice_;
  double dt_;
  const State* state_;
  const std::vector<double>* thermal_strain_;
  const MovingPlate* moving_ = nullptr;  // knows what acts
  double until_ = 0.0;
  std::optional<Instant> instant_;  // none: the last step
};

}  // namespace hackle
