// SPDX-License-Identifier: MIT
// When each node came to lie on a crack (crack_bands.hpp): what the graph of the cracks is made of.
// Kept up to date from the bonds that break, so it costs in proportion to those, and nothing before
// the first does.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "measure/just_broken.hpp"
#include "solver/simulation.hpp"
#include "solver/view.hpp"

namespace hackle {

class CrackGrowth {
 public:
  static constexpr double at_start = -std::numeric_limits<double>::infinity();
  static constexpr double never = std::numeric_limits<double>::infinity();

  // Takes up the present step: only the bonds that have just broken, if it follows the last one;
  // begins anew where steps are missing.
  void follow(const Simulation& simulation);
  // Takes up a later state, or any first one: nodes that have come since have its time. A state
  // of another lattice, or an earlier one, begins anew.
  void look(const View& view);

  // The same, also where nothing has broken, for the cracks of the scene.
  void count(const Simulation& simulation);

  bool empty() const { return nodes_.empty(); }
  const Grid& grid() const { return grid_; }
  double m() const { return m_; }        // horizon, dx
  double time() const { return time_; }  // s, of what was seen last
  // The first moment that was seen, s: what had come by then came earlier.
  double since() const { return since_; }
  double interval() const { return interval_; }  // s, the longest between two looks
  double rayleigh() const { return rayleigh_; }  // m/s, speed of Rayleigh waves

  // The first bond that broke: the middle of those that broke with it within a horizon. Nothing
  // before one has, or if one had when the growth was first seen.
  struct FirstBreak {
    double time = 0.0;  // s
    Vec2 place{0, 0};   // m
  };
  const std::optional<FirstBreak>& first_break() const { return first_break_; }

  // The nodes on cracks in the order of their arrival, by Grid::index.
  const std::vector<std::size_t>& nodes() const { return nodes_; }
  // Returns when a node came onto a crack, s; or one of the two above.
  double arrival(std::size_t node) const { return arrival_[node]; }
  // Returns the share of broken bonds of a node; 0.5 beside a crack that was born absent.
  double damage(int i, int j) const;
  // Whether a node lies on the plate, and not in a hole.
  bool holds(int i, int j) const;

 private:
  void begin(const View& view);
  void catch_up(const View& view);
  void examine(std::size_t node, double time);
  void mark_absent_cracks(const Plate& plate);
  void note_first(const std::vector<LostBond>& lost);

  Grid grid_{};
  double m_ = 0.0;
  double rayleigh_ = 0.0;
  std::int64_t step_ = -1;
  Clock clock_;
  double time_ = 0.0;
  double since_ = 0.0;
  double interval_ = 0.0;
  std::vector<std::uint16_t> initial_, left_;  // bonds of a node; empty before the first breaks
  std::vector<double> arrival_;
  std::vector<std::size_t> nodes_;
  bool any_broken_ = false;
  std::optional<FirstBreak> first_break_;
};

}  // namespace hackle
