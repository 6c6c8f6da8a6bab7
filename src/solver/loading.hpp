// SPDX-License-Identifier: MIT
// What acts on a plate in time: forces in a step, contacts and impacts among them, and where nodes
// are being led.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lattice/load_map.hpp"
#include "solver/contact_forces.hpp"
#include "solver/impact.hpp"
#include "solver/meetings.hpp"
#include "solver/state.hpp"

namespace hackle {

// A factor of time, asked at the steps of a run.
class TabulatedAmplitude {
 public:
  // In a step the factor holds of the time when `shift` of it is over.
  TabulatedAmplitude(Amplitude amplitude, double shift)
      : amplitude_(std::move(amplitude)), shift_(shift) {}

  bool is_constant() const { return amplitude_.is_constant(); }
  // Asks a function for the steps begin <= n < end, so that at() need not. Throws Error (refused)
  // for more than 1e8 of them.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt);
  double at(const Clock& clock, std::int64_t step, double dt) const;
  const Amplitude& amplitude() const { return amplitude_; }

 private:
  double evaluate(const Clock& clock, std::int64_t step, double dt) const {
    return amplitude_.at(clock.time(step, shift_, dt));
  }

  Amplitude amplitude_;
  double shift_;
  Clock clock_;             // of the table
  std::int64_t first_ = 0;  // step of table_[0]
  std::vector<double> table_;
};

// Where a held node goes in this step.
struct PrescribedNode {
  int i = 0;
  int j = 0;
  Vec2 move{0, 0};  // change of u in the step, lattice units
  bool along_x = true;
  bool along_y = true;
  double inertia = 1.0;  // density there over Lattice::rho
};

// Wall time of finding what acts, s.
struct LoadSeconds {
  double contact = 0.0;
  double impact = 0.0;
  double all = 0.0;  // loads that vary and supports, too

  double others() const { return all - contact - impact; }
};

class Loading {
 public:
  // Throws what spread_forces, spread_supports and Impact throw.
  Loading(const Plate& plate, const Lattice& lattice, double dt);

  // Functions of time are asked now for all steps begin <= n < end. Throws what they throw.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end);

  // Takes up a state that is not the one of the last step: bonds, and the discs that it does not
  // have yet. Throws what Impact::begin throws.
  void begin(const Lattice& lattice, State& state);
  // A step has been done, and these bonds broke in it. `heat` is the thermal strain by Grid::index,
  // empty for 0, here as below.
  void follow(const Lattice& lattice, State& state, const std::vector<double>& heat,
              std::span<const BrokenBond> broken_bonds, LoadSeconds& seconds);
  // Finds what acts in the step that begins with this state. True when it is not what it was.
  bool update(const Lattice& lattice, const State& state, const std::vector<double>& heat,
              LoadSeconds& seconds);
  // Finds what acts on a plate that stands still at the time of u: loads and displacements of this
  // very moment, whatever the step; without contacts and impacts. Nodes that are led at a velocity
  // go as far as that makes in the time that has `passed` since they were where they are, s.
  // update() must follow before the next step, and says true then.
  void halt(const State& state, double passed);

  // Each node once, ordered by index.
  const std::vector<LoadedNode>& forces() const { return all_; }
  const std::vector<PrescribedNode>& prescribed() const { return prescribed_; }
  // Whether forces of loads and impacts differ from step to step.
  bool varies() const { return varies_ || !impact_.empty(); }
  // Adds the work that loads and impacts do in a step, of which `state` is the end: all of it, or,
  // when they vary, the half of those that acted at its beginning; what acts at its end does the
  // other half.
  void add_work(const Lattice& lattice, const State& state, double& work) const;
  // What is stored in contacts at the time of update(), and what bonds that broke in the step
  // before it took from that. All three in units of rho dx^4/dt^2.
  double contact_energy() const { return contact_ ? contact_->energy() : 0.0; }
  double contact_lost() const { return contact_ ? contact_->lost() : 0.0; }
  // How much of contact_energy() a change of the thermal strain adds while nodes stay.
  double contact_heat_work(const std::vector<double>& before,
                           const std::vector<double>& after) const {
    return contact_ ? contact_->heat_work(before, after) : 0.0;
  }
  // Of all that grows with the plate, whatever acts on it.
  std::size_t bytes() const { return contact_ ? contact_->bytes() : 0; }

 private:
  // What one load adds to the entries of forces_ or prescribed_.
  struct Force {
    std::vector<std::size_t> at;
    std::vector<Vec2> acceleration;  // m/s2
    TabulatedAmplitude amplitude;
  };
  struct Prescription {
    std::vector<std::size_t> at;
    std::vector<Vec2> value;  // in units of dx: of u, or of its change in a step
    bool along_x, along_y;
    Support::Kind kind;
    TabulatedAmplitude amplitude;
  };

  void add(const std::vector<SpreadForce>& forces, const Grid& grid);
  void find_crowds();
  void add(const std::vector<SpreadSupport>& supports, const Lattice& lattice);
  template <class Factor>
  void sum_forces(const Factor& factor);
  bool touch(const Lattice& lattice, const State& state, const std::vector<double>& heat,
             LoadSeconds& seconds);
  template <class Factor>
  void prescribe(const State& state, const Factor& factor);

  double dt_;
  std::vector<Force> parts_;
  std::vector<Meeting> crowds_;  // entries of forces_ with three parts or more
  std::vector<Prescription> prescriptions_;
  std::vector<LoadedNode> forces_;  // of the loads alone
  std::vector<LoadedNode> all_;
  std::vector<PrescribedNode> prescribed_;
  std::optional<ContactForces> contact_;
  Impact impact_;
  bool varies_ = false;
  bool fresh_ = true;  // what acts is not what update() found last
};

}  // namespace hackle
