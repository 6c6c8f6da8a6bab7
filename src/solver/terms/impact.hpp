// SPDX-License-Identifier: MIT
// Rigid discs that fly freely in the plane of the plate and push every node whose cell they
// overlap, by the law of contact (contact_forces.hpp) with the overlap R - r in place of d - r: r
// is the distance to the nearest point of the cell, the square of one spacing around the node that
// pictures show, and the push acts along that line. So a disc touches the plate where it is drawn.
// Nodes push the disc back.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/terms/bearing.hpp"
#include "solver/terms/term.hpp"

namespace hackle {

class Impact final : public Term {
 public:
  // Throws Error (refused) for discs that are too small or too light for the spacing.
  Impact(const Plate& plate, const Lattice& lattice, double dt);

  std::unique_ptr<Term> clone() const override { return std::make_unique<Impact>(*this); }
  std::string_view name() const override { return "impactors"; }
  // Puts the discs that the state does not have yet where they start. Throws Error (refused) when
  // one reaches into a cell; the state is then as before.
  void begin(const Surroundings& around, State& state) override;
  // Moves the discs by the step in which the forces act.
  void follow(const Surroundings&, State& state) override;
  // Finds the pushed nodes at displacement u.
  bool update(const Surroundings& around, State& state) override;
  std::span<const LoadedNode> forces() const override { return forces_; }
  bool varies() const override { return true; }
  void add_work(const Surroundings& around, const State& state, WorkOf part,
                double& work) const override;
  void add_reactions(const Surroundings& around, const State& state,
                     std::vector<Reaction>& list) const override;
  void check_rest(const std::string& who) const override;

 private:
  struct RigidDisc {
    Impactor impactor;
    double radius;                  // dx
    double mass;                    // of a node of the plate's own material
    Vec2 push{0, 0};                // by the plate on the disc, in units of rho dx^3/dt^2
    Bearing push_on_nodes;          // the same with its moment
    std::vector<std::size_t> near;  // nodes that it may push until watch_again_
  };

  Disc start_of(const RigidDisc& disc, const Lattice& lattice) const;
  void check_start(const RigidDisc& disc, const Disc& place, const Lattice& lattice,
                   const State& state) const;
  void watch(const Lattice& lattice, const State& state);
  std::vector<LoadedNode> push(RigidDisc& disc, const Disc& place, const Lattice& lattice,
                               const State& state) const;

  std::vector<RigidDisc> discs_;
  double dt_;
  double strength_;               // force on a node of the plate's own material, per overlap
  std::int64_t watch_again_ = 0;  // step
  std::vector<LoadedNode> forces_;
};

}  // namespace hackle
