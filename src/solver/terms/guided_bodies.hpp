// SPDX-License-Identifier: MIT
// Rollers and platens: rigid discs and boxes that a machine leads. They push every node whose cell
// they overlap by the law of impactors (impact.hpp); a box pushes along the axis by which it is
// left sooner. What they do to the plate is the work of a load (src/solver/README.md 7.9).
#pragma once

#include <cstdint>
#include <vector>

#include "solver/terms/bearing.hpp"
#include "solver/terms/guided_body.hpp"
#include "solver/terms/term.hpp"

namespace hackle {

// A body that stands, in the units of LinearisedBonds.
struct RestingBody {
  GuidedBody body;
  Vec2 centre{0, 0};   // dx from the centre of the lattice
  double force = 0.0;  // that leads it, along body.along(): force densities of nodes add up to it
};

struct RestingBodies {
  std::vector<RestingBody> list;
  double strength = 0.0;  // force density per overlap, of a node of the plate's own material
};

class GuidedBodies final : public Term {
 public:
  // See guided_bodies() for what it throws.
  GuidedBodies(const Plate& plate, const Lattice& lattice, double dt);

  std::unique_ptr<Term> clone() const override { return std::make_unique<GuidedBodies>(*this); }
  std::string_view name() const override { return "rollers and platens"; }
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) override;
  void begin(const Surroundings& around, State& state) override;
  void follow(const Surroundings& around, State& state) override;
  bool update(const Surroundings& around, State& state) override;
  std::span<const LoadedNode> forces() const override { return forces_; }
  bool varies() const override { return true; }
  void add_work(const Surroundings& around, const State& state, WorkOf part,
                double& work) const override;
  void add_reactions(const Surroundings& around, const State& state,
                     std::vector<Reaction>& list) const override;

  // Returns the bodies where they are led at the time of the state, or where they are in it.
  RestingBodies led(const Lattice& lattice, const State& state, double dt) const;
  RestingBodies placed(const Lattice& lattice, const State& state, double dt) const;
  // Puts bodies that forces lead where they stand.
  void stand(const std::vector<RestingBody>& bodies, State& state) const;

 private:
  // What a body has to do with the plate.
  struct Touch {
    std::vector<std::size_t> near;  // nodes that it may push until they are watched again
    Vec2 push{0, 0};                // by the plate on it
    Bearing push_on_nodes;          // the same with its moment
  };

  // The state has the places of rollers and platens apart.
  template <class StateOrConst>
  auto& place(StateOrConst& state, std::size_t k) const {
    return k < rollers_ ? state.rollers[k] : state.platens[k - rollers_];
  }
  void lead(double dt, State& state) const;
  void watch(const Surroundings& around, const State& state);
  std::vector<LoadedNode> push(std::size_t k, const Surroundings& around, const State& state);

  std::size_t rollers_;  // the first of the bodies
  double strength_;      // force on a node of the plate's own material, per overlap
  std::vector<GuidedBody> bodies_;
  std::vector<Touch> touch_;      // of each body
  std::int64_t watch_again_ = 0;  // step
  std::vector<LoadedNode> forces_;
};

}  // namespace hackle
