// SPDX-License-Identifier: MIT
#include "solver/statics/coarse_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/SparseCholesky>

#include "solver/statics/rigid_contacts.hpp"

namespace hackle {
namespace {

// The cost of Cholesky's factorisation grows with the square of the number of parts.
constexpr double max_blocks = 2048.0;
constexpr int min_width = 3;
// Added to the diagonal, as a share: single-node parts rotate as they shift, free fragments move
// without resistance, and forces along such motions have been removed.
constexpr double softness = 1e-9;

// Returns the borders of mirror-symmetric parts, about `width` wide, of n nodes.
std::vector<int> cuts(int n, int width) {
  int parts = std::max(1, (n + width / 2) / width);
  if (n % 2 == 1 && parts % 2 == 0) --parts;  // the middle node belongs to the middle part
  std::vector<int> ends;
  for (int k = 0; k <= parts; ++k)
    ends.push_back(2 * k <= parts ? k * n / parts : n - (parts - k) * n / parts);
  return ends;
}

using Row = Eigen::Matrix<double, 2, 3>;
using Coupling = Eigen::Matrix3d;

// Returns how a node moves with its part: shifts, and a rotation about the centre of the block.
Row motion_of(const Vec2& arm, double mobile_x, double mobile_y) {
  Row row;
  row << mobile_x, 0.0, -mobile_x * arm.y(), 0.0, mobile_y, mobile_y * arm.x();
  return row;
}

}  // namespace

struct CoarseSpace::Factor {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
  Eigen::VectorXd right, left;
};

CoarseSpace::CoarseSpace(const LinearisedBonds& net, const NodeVectors& mobile,
                         const RigidContacts* contacts)
    : net_(&net), mobile_(&mobile), factor_(std::make_unique<Factor>()) {
  const Grid& grid = net.lattice().grid;
  const double widest = std::sqrt(static_cast<double>(grid.nodes()) / max_blocks);
  width_ = std::max({min_width, net.lattice().family.reach(), static_cast<int>(widest) + 1});
  cut_into_blocks();
  find_mirrors();
  forces_.resize(block_of_part_.size());
  answers_.resize(block_of_part_.size());
  factorise(mobile, contacts);
}

CoarseSpace::~CoarseSpace() = default;

void CoarseSpace::cut_into_blocks() {
  const Grid& grid = net_->lattice().grid;
  const std::vector<int> columns = cuts(grid.nx, width_), rows = cuts(grid.ny, width_);
  part_.assign(grid.nodes(), none);
  std::vector<int> next;
  for (std::size_t q = 0; q + 1 < rows.size(); ++q)
    for (std::size_t p = 0; p + 1 < columns.size(); ++p) {
      blocks_.push_back({columns[p], columns[p + 1], rows[q], rows[q + 1]});
      find_parts(blocks_.back(), next);
    }
}

// Finds the parts of a block: nodes joined by bonds within it; a node without bonds belongs to
// none.
void CoarseSpace::find_parts(Block& block, std::vector<int>& next) {
  const Grid& grid = net_->lattice().grid;
  const auto inside = [&](int i, int j) {
    return i >= block.first_i && i < block.end_i && j >= block.first_j && j < block.end_j;
  };
  block.first_part = static_cast<int>(block_of_part_.size());
  for (int j = block.first_j; j < block.end_j; ++j)
    for (int i = block.first_i; i < block.end_i; ++i) {
      if (part_[grid.index(i, j)] != none || !net_->has_bonds(i, j)) continue;
      const int part = static_cast<int>(block_of_part_.size());
      block_of_part_.push_back(static_cast<int>(blocks_.size()) - 1);
      part_[grid.index(i, j)] = part;
      next.assign(1, static_cast<int>(grid.index(i, j)));
      while (!next.empty()) {
        const int node = next.back();
        next.pop_back();
        net_->for_each_neighbour(node % grid.nx, node / grid.nx, [&](int k, int l) {
          if (!inside(k, l) || part_[grid.index(k, l)] != none) return;
          part_[grid.index(k, l)] = part;
          next.push_back(static_cast<int>(grid.index(k, l)));
        });
      }
    }
  block.end_part = static_cast<int>(block_of_part_.size());
}

void CoarseSpace::find_mirrors() {
  const Grid& grid = net_->lattice().grid;
  const auto find = [&](std::vector<int>& mirror, const auto& image) {
    mirror.assign(block_of_part_.size(), none);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const int own = part_[grid.index(i, j)], other = part_[image(i, j)];
        if ((own == none) != (other == none)) return mirror.clear();
        if (own == none) continue;
        int& known = mirror[static_cast<std::size_t>(own)];
        if (known == none) known = other;
        if (known != other) return mirror.clear();
      }
  };
  find(left_right_, [&](int i, int j) { return grid.index(grid.nx - 1 - i, j); });
  find(up_down_, [&](int i, int j) { return grid.index(i, grid.ny - 1 - j); });
}

Vec2 CoarseSpace::arm(const Block& block, int i, int j) const {
  const double half = 0.5 * width_;
  return {(i - 0.5 * (block.first_i + block.end_i - 1)) / half,
          (j - 0.5 * (block.first_j + block.end_j - 1)) / half};
}

// Bonds within one part contribute little, since it moves as a rigid body.
void CoarseSpace::factorise(const NodeVectors& mobile, const RigidContacts* contacts) {
  const Grid& grid = net_->lattice().grid;
  const std::size_t parts = block_of_part_.size();
  if (parts == 0) return;  // without intact bonds
  std::vector<std::vector<std::pair<int, Coupling>>> rows(parts);
  const auto coupling = [&](int a, int b) -> Coupling& {
    auto& row = rows[static_cast<std::size_t>(a)];
    for (auto& [other, matrix] : row)
      if (other == b) return matrix;
    return row.emplace_back(b, Coupling::Zero()).second;
  };
  std::vector<Row> motions(grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int part = part_[grid.index(i, j)];
      if (part == none) continue;
      const auto at = static_cast<std::size_t>(net_->layout().at(i, j));
      const auto& block =
          blocks_[static_cast<std::size_t>(block_of_part_[static_cast<std::size_t>(part)])];
      motions[grid.index(i, j)] = motion_of(arm(block, i, j), mobile.x[at], mobile.y[at]);
    }
  const auto add_spring = [&](const RigidContacts::Spring& spring) {
    const std::size_t node = grid.index(spring.i, spring.j);
    const int part = part_[node];
    if (part == none) return;
    Eigen::Matrix2d stiff;
    stiff << spring.stiffness.xx, spring.stiffness.xy, spring.stiffness.xy, spring.stiffness.yy;
    coupling(part, part) += motions[node].transpose() * (stiff * motions[node]);
  };
  if (contacts != nullptr) std::ranges::for_each(contacts->springs(), add_spring);
  net_->for_each_stiffness([&](std::size_t one, std::size_t other, const Stiffness& k) {
    const int a = part_[one], b = part_[other];
    Eigen::Matrix2d stiff;
    stiff << k.xx, k.xy, k.xy, k.yy;
    const Row &p = motions[one], &q = motions[other];
    const Row kp = stiff * p, kq = stiff * q;
    coupling(a, a) += p.transpose() * kp;
    coupling(b, b) += q.transpose() * kq;
    if (a == b) {
      const Coupling mixed = p.transpose() * kq;
      coupling(a, a) -= mixed + mixed.transpose();
    } else if (a > b) {
      coupling(a, b) -= p.transpose() * kq;
    } else {
      coupling(b, a) -= q.transpose() * kp;
    }
  });
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t a = 0; a < parts; ++a)
    for (const auto& [b, matrix] : rows[a])
      for (int m = 0; m < 3; ++m)
        for (int n = 0; n < 3; ++n) {
          const int row = 3 * static_cast<int>(a) + m, column = 3 * b + n;
          if (column > row) continue;
          double value = matrix(m, n);
          if (row == column) value = value > 0.0 ? value * (1.0 + softness) : 1.0;
          entries.emplace_back(row, column, value);
        }
  const auto size = static_cast<Eigen::Index>(3 * parts);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_->ldlt.compute(matrix);
  is_positive_ = factor_->ldlt.info() == Eigen::Success && factor_->ldlt.vectorD().minCoeff() > 0.0;
  factor_->right.resize(size);
}

CoarseSpace::Body CoarseSpace::sum_of(const Block& block, int part, const NodeVectors& r) const {
  const Grid& grid = net_->lattice().grid;
  const auto over = [&](const auto& term) {
    return paired_sum(block.end_j - block.first_j, [&](int row) {
      const int j = block.first_j + row;
      return paired_sum(block.end_i - block.first_i, [&](int column) {
        const int i = block.first_i + column;
        if (part_[grid.index(i, j)] != part) return 0.0;
        return term(arm(block, i, j), static_cast<std::size_t>(net_->layout().at(i, j)));
      });
    });
  };
  return {over([&](const Vec2&, std::size_t at) { return r.x[at]; }),
          over([&](const Vec2&, std::size_t at) { return r.y[at]; }),
          over([&](const Vec2& x, std::size_t at) { return x.x() * r.y[at] - x.y() * r.x[at]; })};
}

namespace {

// Returns the mirror image of a force or motion.
std::array<double, 3> mirror_image(const std::array<double, 3>& body, bool left_right) {
  return {left_right ? -body[0] : body[0], left_right ? body[1] : -body[1], -body[2]};
}

}  // namespace

bool CoarseSpace::is_symmetric(const std::vector<int>& mirror, bool left_right) const {
  for (std::size_t part = 0; part < mirror.size(); ++part)
    if (forces_[part] != mirror_image(forces_[static_cast<std::size_t>(mirror[part])], left_right))
      return false;
  return !mirror.empty();
}

// Rounding in the factorisation is not symmetric.
void CoarseSpace::make_symmetric(const std::vector<int>& mirror, bool left_right) {
  const std::vector<Body> before = answers_;
  for (std::size_t part = 0; part < mirror.size(); ++part) {
    const Body other = mirror_image(before[static_cast<std::size_t>(mirror[part])], left_right);
    for (std::size_t k = 0; k < 3; ++k) answers_[part][k] = 0.5 * (before[part][k] + other[k]);
  }
}

void CoarseSpace::add_answer(const NodeVectors& r, NodeVectors& z) {
  if (forces_.empty()) return;
  for_rows(net_->threads(), static_cast<int>(blocks_.size()), [&](int k) {
    const Block& block = blocks_[static_cast<std::size_t>(k)];
    for (int part = block.first_part; part < block.end_part; ++part)
      forces_[static_cast<std::size_t>(part)] = sum_of(block, part, r);
  });
  for (std::size_t part = 0; part < forces_.size(); ++part)
    for (std::size_t k = 0; k < 3; ++k)
      factor_->right[static_cast<Eigen::Index>(3 * part + k)] = forces_[part][k];
  factor_->left = factor_->ldlt.solve(factor_->right);
  for (std::size_t part = 0; part < forces_.size(); ++part)
    for (std::size_t k = 0; k < 3; ++k)
      answers_[part][k] = factor_->left[static_cast<Eigen::Index>(3 * part + k)];
  if (is_symmetric(left_right_, true)) make_symmetric(left_right_, true);
  if (is_symmetric(up_down_, false)) make_symmetric(up_down_, false);
  const Grid& grid = net_->lattice().grid;
  for_rows(net_->threads(), static_cast<int>(blocks_.size()), [&](int k) {
    const Block& block = blocks_[static_cast<std::size_t>(k)];
    for (int j = block.first_j; j < block.end_j; ++j)
      for (int i = block.first_i; i < block.end_i; ++i) {
        const int part = part_[grid.index(i, j)];
        if (part == none) continue;
        const Body& body = answers_[static_cast<std::size_t>(part)];
        const Vec2 x = arm(block, i, j);
        const auto at = static_cast<std::size_t>(net_->layout().at(i, j));
        z.x[at] += mobile_->x[at] * (body[0] - body[2] * x.y());
        z.y[at] += mobile_->y[at] * (body[1] + body[2] * x.x());
      }
  });
}

}  // namespace hackle
