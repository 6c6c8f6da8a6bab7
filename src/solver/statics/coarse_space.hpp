// SPDX-License-Identifier: MIT
// A coarse space for conjugate gradients: blocks of the plate as rigid bodies. It resolves the long
// waves, which conjugate gradients find slowly (src/solver/README.md 8.2).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/statics/linearised_bonds.hpp"

namespace hackle {

// The plate is divided into square blocks, a horizon wide if they are few, and blocks into parts
// where cracks divide them. Each part moves as a rigid body: two shifts and a rotation. On these
// motions the tangent of the net is small enough to factorise (Galerkin's projection, Eigen's
// sparse Cholesky).
class RigidContacts;

class CoarseSpace {
 public:
  // Takes the tangent of the net, with the bonds that are intact now, and the springs of contacts.
  CoarseSpace(const LinearisedBonds& net, const NodeVectors& mobile,
              const RigidContacts* contacts = nullptr);
  ~CoarseSpace();

  // Returns false if the tangent has motions of negative stiffness: then it must not be used.
  bool is_positive() const { return is_positive_; }

  // Adds to z the response of the parts to the forces r. Both are 0 on prescribed components. The
  // bits are the same for any number of threads; if the forces on the parts are their own mirror
  // image, so is the response, to the last bit.
  void add_answer(const NodeVectors& r, NodeVectors& z);

 private:
  static constexpr int none = -1;
  // For a part: the force along x and y, and the moment about the centre of its block over half the
  // width of a block; or the shifts, and the rotation times that half width.
  using Body = std::array<double, 3>;
  struct Block {
    int first_i = 0, end_i = 0, first_j = 0, end_j = 0;
    int first_part = 0, end_part = 0;
  };
  struct Factor;

  void cut_into_blocks();
  void find_parts(Block& block, std::vector<int>& next);
  void find_mirrors();
  void factorise(const NodeVectors& mobile, const RigidContacts* contacts);
  Vec2 arm(const Block& block, int i, int j) const;
  Body sum_of(const Block& block, int part, const NodeVectors& r) const;
  void make_symmetric(const std::vector<int>& mirror, bool left_right);
  bool is_symmetric(const std::vector<int>& mirror, bool left_right) const;

  const LinearisedBonds* net_;
  const NodeVectors* mobile_;
  int width_;  // of a block, in nodes
  std::vector<Block> blocks_;
  std::vector<int> part_;  // of a node, by Grid::index
  std::vector<int> block_of_part_;
  std::vector<int> left_right_, up_down_;  // the mirror image of each part; empty if there is none
  std::vector<Body> forces_, answers_;
  std::unique_ptr<Factor> factor_;
  bool is_positive_ = true;
};

}  // namespace hackle
