// SPDX-License-Identifier: MIT
// The fragments of a plate that bonds hold together, and how they can move without stretching a
// bond.
#pragma once

#include <vector>

#include "lattice/lattice.hpp"
#include "solver/node_vectors.hpp"
#include "solver/state.hpp"

namespace hackle {

// A motion without strain: a translation, and a turn about the centre of the fragment. For small
// angles.
struct RigidMotion {
  Vec2 shift{0, 0};
  double turn = 0.0;
};

// Nodes that are joined by bonds which hold, in the box of columns first_i..last_i and rows
// first_j..last_j. Lengths in dx.
struct Fragment {
  int first_i = 0, last_i = 0, first_j = 0, last_j = 0;
  int nodes = 0;
  Vec2 centre{0, 0};                 // of its nodes, from the centre of the lattice
  double inertia = 0.0;              // sum of the squared distances from there
  bool is_held = false;              // a support holds some of its nodes, along one axis at least
  std::vector<RigidMotion> motions;  // which no support hinders; three when it is not held
};

// Of forces on the nodes of a fragment.
struct Resultant {
  Vec2 force{0, 0};
  double moment = 0.0;  // about the centre of the fragment
  double virial = 0.0;  // sum of x . force, x from there
};

class Fragments {
 public:
  // `mobile` is 1 where a support lets a node move along x (y), 0 where not.
  Fragments(const Lattice& lattice, const State& state, const NodeVectors& mobile, Threads threads);

  // A node without bonds belongs to none.
  const std::vector<Fragment>& list() const { return list_; }

  // The resultant of `force` on the nodes displaced by u.
  Resultant resultant(std::size_t fragment, const NodeVectors& force, const NodeVectors& u) const;
  // Takes the rigid motions of fragments that no support holds out of a vector.
  void take_out_rigid(NodeVectors& vector) const;
  // Turns a fragment about the centre of its nodes by any angle (rad); bonds do not notice.
  void turn(std::size_t fragment, double angle, NodeVectors& u) const;

 private:
  static constexpr int none = -1;

  std::vector<std::size_t> roots(const Lattice& lattice, const State& state) const;
  void list_fragments(const std::vector<std::size_t>& root, const NodeVectors& mobile);
  // Calls work(x, place) for the nodes of row j, x from the centre of the fragment.
  template <class Work>
  void for_row(std::size_t fragment, int j, const Work& work) const;
  // Sum of term(x, place) over the nodes of a fragment; opposite or the same for its mirror image.
  template <class Term>
  double sum(std::size_t fragment, const Term& term) const;
  void measure(std::size_t fragment);
  void find_motions(std::size_t fragment, const NodeVectors& mobile);

  Grid grid_;
  NodeLayout layout_;
  Threads threads_;
  std::vector<int> of_node_;  // place in list_, or none
  std::vector<Fragment> list_;
};

}  // namespace hackle
