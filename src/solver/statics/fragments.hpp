// SPDX-License-Identifier: MIT
// The fragments of a plate, whose nodes are joined by bonds, and their motions without stretch of a
// bond.
#pragma once

#include <vector>

#include "lattice/lattice.hpp"
#include "solver/node_vectors.hpp"
#include "solver/state.hpp"

namespace hackle {

// A motion without strain: a translation, and a rotation about the centre of the fragment. For
// small angles.
struct RigidMotion {
  Vec2 shift{0, 0};
  double turn = 0.0;
};

// Nodes joined by intact bonds, in the box of columns first_i..last_i and rows first_j..last_j.
// Lengths in dx.
struct Fragment {
  int first_i = 0, last_i = 0, first_j = 0, last_j = 0;
  int nodes = 0;
  Vec2 centre{0, 0};                 // mean of its nodes, from the centre of the lattice
  double inertia = 0.0;              // sum of the squared distances from `centre`
  bool is_held = false;              // some of its nodes are held, along at least one axis
  std::vector<RigidMotion> motions;  // that nothing prevents; three if it is not held
};

// A node that cannot go along a direction, a unit vector.
struct Hold {
  int i = 0, j = 0;
  Vec2 along{0, 0};
};

// The resultant of forces on the nodes of a fragment.
struct Resultant {
  Vec2 force{0, 0};
  double moment = 0.0;  // about the centre of the fragment
  double virial = 0.0;  // sum of x . force, x from `centre`
};

class Fragments {
 public:
  // `mobile` is 1 where a node is free along x (y), 0 where it is prescribed.
  // `holds` are nodes that something else holds along a direction.
  Fragments(const Lattice& lattice, const State& state, const NodeVectors& mobile, Threads threads,
            const std::vector<Hold>& holds = {});

  // A node without bonds belongs to no fragment.
  const std::vector<Fragment>& list() const { return list_; }

  // Returns the resultant of `force` on the nodes displaced by u.
  Resultant resultant(std::size_t fragment, const NodeVectors& force, const NodeVectors& u) const;
  // Removes the rigid motions of free fragments from a vector.
  void take_out_rigid(NodeVectors& vector) const;
  // Rotates a fragment about the centre of its nodes by any angle (rad), which stretches no bond.
  void turn(std::size_t fragment, double angle, NodeVectors& u) const;

 private:
  static constexpr int none = -1;

  std::vector<std::size_t> roots(const Lattice& lattice, const State& state) const;
  void list_fragments(const std::vector<std::size_t>& root, const NodeVectors& mobile);
  // Calls work(x, place) for the nodes of row j, x from the centre of the fragment.
  template <class Work>
  void for_row(std::size_t fragment, int j, const Work& work) const;
  // Computes the sum of term(x, place) over the nodes of a fragment; it is opposite or equal for
  // the mirror image.
  template <class Term>
  double sum(std::size_t fragment, const Term& term) const;
  void measure(std::size_t fragment);
  void find_motions(std::size_t fragment, const NodeVectors& mobile,
                    const std::vector<Hold>& holds);

  Grid grid_;
  NodeLayout layout_;
  Threads threads_;
  std::vector<int> of_node_;  // index in list_, or none
  std::vector<Fragment> list_;
};

}  // namespace hackle
