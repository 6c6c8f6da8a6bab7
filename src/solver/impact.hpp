// SPDX-License-Identifier: MIT
// Rigid discs that fly freely in the plane of the plate and push every node whose cell they reach
// into, by the law of contact (contact_forces.hpp) with the overlap R - r for d - r: r is the way
// to the nearest point of the cell, the square of one spacing around the node that pictures show,
// and the push is along it. So a disc touches what is drawn. What pushes a node pushes the disc
// back.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"
#include "lattice/load_map.hpp"
#include "solver/state.hpp"

namespace hackle {

class Impact {
 public:
  // Throws Error (refused) for discs too small or too light for the spacing.
  Impact(const Plate& plate, const Lattice& lattice, double dt);

  bool empty() const { return discs_.empty(); }

  // Puts the discs that the state does not have yet where they start. To be called before anything
  // else, and whenever a state is not the one of the last step. Throws Error (refused) when one
  // reaches into a cell; the state is then as before.
  void begin(const Lattice& lattice, State& state);
  // Finds what is pushed at the time of u.
  void update(const Lattice& lattice, const State& state);
  // Moves the discs on by the step that the forces act in.
  void fly(State& state) const;

  // What update() found: each node once, ordered by index.
  const std::vector<LoadedNode>& forces() const { return forces_; }

 private:
  struct RigidDisc {
    Impactor impactor;
    double radius;                  // dx
    double mass;                    // of a node of the plate's own material
    Vec2 push{0, 0};                // of the plate on the disc, in units of rho dx^3/dt^2
    std::vector<std::size_t> near;  // nodes that it may push until watch_again_
  };

  Disc start_of(const RigidDisc& disc, const Lattice& lattice) const;
  void check_start(const RigidDisc& disc, const Disc& place, const Lattice& lattice,
                   const State& state) const;
  void watch(const Lattice& lattice, const State& state);
  std::vector<LoadedNode> push(RigidDisc& disc, const Vec2& centre, const Lattice& lattice,
                               const State& state) const;

  std::vector<RigidDisc> discs_;
  double dt_;
  double strength_;               // of the force on a node of the plate's own material, per overlap
  std::int64_t watch_again_ = 0;  // step
  std::vector<LoadedNode> forces_;
};

}  // namespace hackle
