// SPDX-License-Identifier: MIT
// The faces of closed cracks carry pressure. A node that lost bonds, to a crack or by breaking, has
// approached the nodes beyond the crack by the mean stretch of its lost bonds,
//
//   eps = sum K s / sum K,   K = c w L.
//
// Where eps < 0 the faces are closed: the node stores k/4 sum K eps^2, and every lost bond pushes
// along itself with k c w (eps_i + eps_j)/2, where eps of an end counts as 0 if it is above 0. k =
// 6/5 makes a face bear as much as its bonds, which lie in all directions
// (src/solver/README.md 7.1).
//
// Without friction faces slide freely, because bonds that lean one way are shortened as much as
// those that lean the other way are lengthened; and they rotate freely, because s does not change.
// The weight of a lost bond decreases as it is stretched, and is 0 at five times its length: faces
// that have separated meet again as unrelated ones (contact_forces.hpp).
#pragma once

#include <span>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/order_free_sum.hpp"
#include "solver/terms/open_node.hpp"

namespace hackle {

class CrackFaces {
 public:
  CrackFaces(const Lattice& lattice, double dt);

  // The vector from the node that keeps a bond to its other end.
  struct Way {
    int columns = 0;
    int rows = 0;
  };
  Way way(int bit) const { return offsets_[static_cast<std::size_t>(bit)].way; }

  void clear();
  // Registers a lost bond between two nodes, given as indices in a list that only grows; `bit` as
  // in Family, kept by `one`.
  void lose(const Lattice& lattice, std::span<const OpenNode> nodes, int one, int other, int bit);
  // Finds the lost bonds that matter until a node has moved from its home by `slack`, dx. Call this
  // when homes have changed; bonds lost later are always considered.
  void find_near(std::span<const OpenNode> nodes, double slack);

  // Adds to the forces on the nodes, and to their losses with a coefficient of friction above 0;
  // `heat` is the thermal strain by Grid::index, empty for 0, here as below. Returns the stored
  // energy, in units of rho dx^4/dt^2.
  double push(std::span<OpenNode> nodes, const std::vector<double>& heat, double friction);
  // Returns only the stored energy.
  double energy(std::span<const OpenNode> nodes, const std::vector<double>& heat) const;

 private:
  // All bonds of one offset, by bit.
  struct Offset {
    Way way;
    Vec2 xi{0, 0};
    double length = 0.0;
    double weight = 0.0;
  };
  struct LostBond {
    int one = 0;
    int other = 0;
    int bit = 0;
    double pull = 0.0;       // c w, over c of the plate's own material
    double stiffness = 0.0;  // K/2, the share of one end, with lengths in horizons
  };

  const Offset& offset_of(const LostBond& bond) const {
    return offsets_[static_cast<std::size_t>(bond.bit)];
  }
  double stretch_of(const LostBond& bond, std::span<const OpenNode> nodes,
                    const std::vector<double>& heat) const;
  double approach_of(const LostBond& bond) const;  // the mean of eps of its ends
  Vec2 force_of(const LostBond& bond, std::span<const OpenNode> nodes, double s) const;
  // Computes eps of every node, or 0 where its faces are open. Returns whether some are closed.
  bool find_closed(std::span<const OpenNode> nodes, const std::vector<double>& heat) const;
  double stored() const;
  void resist(const LostBond& bond, std::span<OpenNode> nodes, const Vec2& force,
              double friction) const;

  double horizon_;   // dx
  double strength_;  // k c dx dt^2/rho of the plate's own material
  std::vector<Offset> offsets_;
  std::vector<LostBond> bonds_;
  std::vector<int> near_;                // in bonds_
  std::vector<OrderFreeSum> stiffness_;  // x: sum K/2, by node
  // The results of the last find_closed().
  mutable std::vector<double> stretches_;      // indexed as near_
  mutable std::vector<OrderFreeSum> nearing_;  // x: sum K s/2, by node
  mutable std::vector<double> approach_;       // eps, by node
};

}  // namespace hackle
