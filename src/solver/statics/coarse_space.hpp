// SPDX-License-Identifier: MIT
// A coarse space for conjugate gradients: blocks of the plate as rigid bodies. It finds the long
// waves, which conjugate gradients are slow to find (src/solver/README.md 8.2).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/statics/linearised_bonds.hpp"

namespace hackle {

// The plate is cut into square blocks, a horizon wide where there are few, and blocks where cracks
// divide them. Each part moves as a rigid body: two shifts and a turn. On these the tangent of the
// net is small enough to be factorised (Galerkin's projection, Eigen's sparse Cholesky).
class CoarseSpace {
 public:
  // Takes the tangent of the net; the bonds are those that hold now.
  CoarseSpace(const LinearisedBonds& net, const NodeVectors& mobile);
  ~CoarseSpace();

  // False where the tangent has motions of negative stiffness: then it must not be used.
  bool is_positive() const { return is_positive_; }

  // Adds to z the answer of the parts to the forces r. Both are 0 where a node is led. The same
  // bits for any number of threads; where the forces on the parts are their own mirror image, so is
  // the answer, to the last bit.
  void add_answer(const NodeVectors& r, NodeVectors& z);

 private:
  static constexpr int none = -1;
  // Of a part, in a body about the centre of its block: force along x and y, and the moment, over
  // half the width of a block; or shifts and a turn times that.
  using Body = std::array<double, 3>;
  struct Block {
    int first_i = 0, end_i = 0, first_j = 0, end_j = 0;
    int first_part = 0, end_part = 0;
  };
  struct Factor;

  void cut_into_blocks();
  void find_parts(Block& block, std::vector<int>& next);
  void find_mirrors();
  void factorise(const NodeVectors& mobile);
  Vec2 arm(const Block& block, int i, int j) const;
  Body sum_of(const Block& block, int part, const NodeVectors& r) const;
  void make_symmetric(const std::vector<int>& mirror, bool left_right);
  bool is_symmetric(const std::vector<int>& mirror, bool left_right) const;

  const LinearisedBonds* net_;
  const NodeVectors* mobile_;
  int width_;  // of a block, nodes
  std::vector<Block> blocks_;
  std::vector<int> part_;  // of a node, by Grid::index
  std::vector<int> block_of_part_;
  std::vector<int> left_right_, up_down_;  // the mirror image of a part; empty when there is none
  std::vector<Body> forces_, answers_;
  std::unique_ptr<Factor> factor_;
  bool is_positive_ = true;
};

}  // namespace hackle
