// SPDX-License-Identifier: MIT
// Rollers and platens that touch a plate at rest, by the law of their push in motion, without
// friction (src/solver/README.md 8.6). In the units of LinearisedBonds: lengths in dx, force
// densities in c dx^2.
#pragma once

#include <string>
#include <vector>

#include "solver/node_vectors.hpp"
#include "solver/statics/linearised_bonds.hpp"
#include "solver/terms/guided_bodies.hpp"

namespace hackle {

class RigidContacts {
 public:
  // A cell that a body overlaps: a spring along the way out of the body.
  struct Spring {
    int i = 0, j = 0;
    std::size_t body = 0;
    Vec2 push{0, 0};      // on the node
    Stiffness stiffness;  // along a unit vector
    Vec2 outward{0, 0};   // that one
  };

  RigidContacts() = default;
  // Both must outlive it. `who` names the user's call in messages.
  RigidContacts(const Lattice& lattice, const State& state, RestingBodies bodies, std::string who);

  // Finds the springs for the displacements u. A body that a force leads goes along it to where
  // its springs bear the force; throws Error (refused) if they nowhere do.
  void find(const NodeVectors& u);
  // The same, with all bodies where they are.
  void find_placed(const NodeVectors& u);
  // Those found last, ordered by body and node.
  const std::vector<Spring>& springs() const { return springs_; }
  const std::vector<RestingBody>& bodies() const { return bodies_; }
  // Returns the nodes that a body which no force leads touches, or nearly touches, at u.
  std::vector<Spring> holds(const NodeVectors& u) const;

  // Returns the rounding error of a push.
  double rounding() const;

  // Adds the pushes to forces on nodes.
  void add_pushes(NodeVectors& force) const;
  // Adds the first-order change of the pushes when u changes by p: bodies that forces lead go
  // along.
  void add_change(const NodeVectors& p, NodeVectors& result) const;

 private:
  template <class Visit>
  void visit_overlaps(const RestingBody& body, const NodeVectors& u, double more,
                      const Visit& visit) const;
  std::vector<Spring> springs_of(std::size_t k, const NodeVectors& u, double more) const;
  void add_springs(const std::vector<Spring>& more);
  std::vector<Spring> borne(std::size_t k, const NodeVectors& u);

  const Lattice* lattice_ = nullptr;
  const State* state_ = nullptr;
  std::vector<RestingBody> bodies_;
  double strength_ = 0.0;  // see RestingBodies
  std::string who_;
  std::vector<Spring> springs_;
};

}  // namespace hackle
