// SPDX-License-Identifier: MIT
#include "peer/reference.hpp"

#include <algorithm>
#include <limits>

namespace hackle::test {

Reference::Reference(const PeerPlate& plate)
    : plate_(plate),
      u_(plate.grid.nodes(), Vec2{0, 0}),
      v_(u_),
      a_(u_),
      s0_(plate.grid.nodes(), std::numeric_limits<double>::infinity()),
      next_s0_(s0_) {
  Family(plate.m, Quadrature::ramp)
      .for_each_bond([&](int a, int b, const Vec2&, double weight, int) {
        family_.push_back({a, b, weight});
        family_.push_back({-a, -b, weight});
      });
  const Grid& grid = plate.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      for (const Bond& bond : family_) {
        const int to_i = i + bond.column, to_j = j + bond.row;
        holds_.push_back(grid.contains(to_i, to_j) && !plate.removed[grid.index(i, j)] &&
                         !plate.removed[grid.index(to_i, to_j)]);
      }
  forces();
}

bool Reference::holds(int i, int j, int column, int row) const {
  const auto bond = std::ranges::find_if(
      family_, [&](const Bond& it) { return it.column == column && it.row == row; });
  return holds_[plate_.grid.index(i, j) * family_.size() +
                static_cast<std::size_t>(bond - family_.begin())];
}

void Reference::step() {
  for (std::size_t n = 0; n < u_.size(); ++n) {
    v_[n] += 0.5 * a_[n];
    u_[n] += v_[n];
  }
  forces();
  for (std::size_t n = 0; n < u_.size(); ++n) v_[n] += 0.5 * a_[n];
}

void Reference::forces() {
  const Grid& grid = plate_.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) pull_on(i, j);
  for (int i = 0; i < grid.nx; ++i) {
    a_[grid.index(i, grid.ny - 1)].y() += plate_.pull;
    a_[grid.index(i, 0)].y() -= plate_.pull;
  }
  s0_.swap(next_s0_);
}

void Reference::pull_on(int i, int j) {
  const std::size_t node = plate_.grid.index(i, j);
  double min = std::numeric_limits<double>::infinity();
  a_[node] = {0, 0};
  for (std::size_t k = 0; k < family_.size(); ++k) {
    char& holds = holds_[node * family_.size() + k];
    if (!holds) continue;
    const Bond& bond = family_[k];
    const std::size_t other = plate_.grid.index(i + bond.column, j + bond.row);
    const Vec2 xi(bond.column, bond.row), eta = u_[other] - u_[node], r = xi + eta;
    const double stretch = eta.dot(xi + r) / (xi.norm() * (r.norm() + xi.norm()));
    a_[node] += plate_.c * bond.weight * stretch * r.normalized();
    if (stretch > std::min(s0_[node], s0_[other])) holds = 0;
    min = std::min(min, stretch);
  }
  next_s0_[node] = plate_.s00 - plate_.alpha * min;
}

}  // namespace hackle::test
