// SPDX-License-Identifier: MIT
// How far the cracks of a plate have come while it is solved, kept up to date from the bonds that
// break: what it costs grows with those, not with the plate.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "solver/simulation.hpp"
#include "solver/view.hpp"

namespace hackle {

class CrackTrack {
 public:
  // The tip is the node on a crack (crack_bands.hpp) that lies farthest along `direction`.
  explicit CrackTrack(const Vec2& direction = {1.0, 0.0});

  // Takes up the present step. If it follows the one before, or is it, only the bonds that have
  // just broken are looked at; else every bond of the plate is.
  void follow(const Simulation& simulation);
  // Takes up any state, looking at every bond.
  void look(const View& view);

  // Returns what a state does not tell: how sums were rounded, and when the tip came where it is;
  // before the first state, what was recalled.
  std::vector<double> memory() const;
  // Called before the first state is taken up by follow(), which is that of the memory.
  void recall(std::vector<double> memory) { recalled_ = std::move(memory); }

  std::int64_t broken_bonds() const { return broken_bonds_; }  // since t = 0
  double broken_energy() const { return broken_energy_; }      // J/m, as Energy::broken
  double max_damage() const { return max_damage_; }            // of a node, 0..1
  // Returns the length, m, of a straight crack along an axis of the lattice that breaks as much:
  // the energy of the broken bonds at the critical stretch of their material, without scatter,
  // over its G0. A crack along another axis, or a frayed one, counts longer.
  double length() const { return length_; }
  // Returns the place of the tip, m: the mean of the extremes where several nodes lie within half a
  // spacing of the farthest. Nothing without a crack.
  std::optional<Vec2> tip() const;
  // Returns how fast it advances along the direction, m/s: its way over the time that it took for
  // the last two horizons, or for all since it first moved. While it stays longer than it took per
  // spacing, the mean falls towards 0. A crack that begins ahead of it counts as an advance.
  double speed() const;
  // Returns the energy of the bonds broken while the tip went these last two horizons, over that
  // way, J/m2; nothing before it moves, and while it stays where it arrived first.
  std::optional<double> energy_per_length() const;
  const Vec2& direction() const { return direction_; }

 private:
  struct Arrival {
    double time = 0.0;    // s
    double along = 0.0;   // dx from the centre of the lattice
    double energy = 0.0;  // J/m, of bonds broken until then
  };

  void begin_anew(const View& view);
  void lose(const View& view, int i, int j, int a, int b, double length, double weight);
  void examine(int i, int j, double damage);
  void note_advance(double time);
  void take_up_memory();

  Vec2 direction_;
  Grid grid_{};
  double window_ = 0.0;  // dx
  Clock clock_;
  std::int64_t step_ = -1;  // the last that was seen
  double time_ = 0.0;       // s
  std::int64_t broken_bonds_ = 0;
  double broken_energy_ = 0.0, length_ = 0.0, max_damage_ = 0.0;
  std::vector<char> on_crack_;  // by Grid::index
  std::vector<Vec2> front_;     // nodes within half a spacing of the farthest, dx from the centre
  double farthest_ = 0.0;       // dx along the direction
  std::deque<Arrival> arrivals_;
  std::vector<double> recalled_;
};

}  // namespace hackle
