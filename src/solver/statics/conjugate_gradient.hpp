// SPDX-License-Identifier: MIT
// Conjugate gradients for the tangent of a net of bonds.
#pragma once

#include <functional>
#include <vector>

#include "solver/statics/coarse_space.hpp"
#include "solver/statics/fragments.hpp"
#include "solver/statics/linearised_bonds.hpp"

namespace hackle {

class RigidContacts;

class ConjugateGradient {
 public:
  struct Outcome {
    int iterations = 0;
    bool is_positive = true;
  };

  // `mobile` is 1 for unknown components and 0 for given ones. `coarse` is a coarse space or
  // nullptr, `contacts` are bodies whose pushes change with the plate, or nullptr. All arguments
  // must outlive the object.
  ConjugateGradient(const LinearisedBonds& net, const Fragments& fragments,
                    const NodeVectors& mobile, CoarseSpace* coarse = nullptr,
                    const RigidContacts* contacts = nullptr);

  // Changes the mobile components of d until the tangent of the net, applied to the whole d,
  // balances `force` at every node: to `share` of the initial residual, or to `goal` in the units
  // of the net; stops after `most` iterations. Free fragments neither move nor rotate as a whole.
  // `look` is called after every iteration with the residual. Returns the number of iterations.
  // Throws what `look` throws.
  //
  // Preconditioned by the 2 x 2 stiffness of each node against its neighbours, and by the coarse
  // space. The bits are the same for any number of threads; mirror-symmetric forces on a
  // mirror-symmetric net give a mirror-symmetric d, to the last bit.
  Outcome solve(const NodeVectors& force, NodeVectors& d, double share, double goal, int max,
                const std::function<void(double left)>& look);

 private:
  struct Sums {
    double product = 0.0, largest = 0.0;
  };

  void invert();
  void apply(const NodeVectors& p, NodeVectors& change);  // first-order change of all forces
  void start(const NodeVectors& force, const NodeVectors& d);
  double curvature();                        // p . K p, and q = -K p
  void go(double distance, NodeVectors& d);  // along p
  Sums precondition();                       // z from r; returns r . z and the largest of r
  double dot(const NodeVectors& a, const NodeVectors& b);
  void turn_to(double share);  // p = z + share p

  const LinearisedBonds* net_;
  const Fragments* fragments_;
  const NodeVectors* mobile_;
  CoarseSpace* coarse_;
  const RigidContacts* contacts_;
  NodeLayout layout_;
  bool has_free_fragments_;
  std::vector<Stiffness> inverse_;  // per node
  NodeVectors p_, q_, r_, z_;
  std::vector<double> of_row_, max_of_row_;
};

}  // namespace hackle
