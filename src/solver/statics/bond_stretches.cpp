// SPDX-License-Identifier: MIT
// Which of the linearised bonds are stretched too far.
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/statics/linearised_bonds.hpp"

namespace hackle {

// Follows the rule of the kernels for the next step. A node without bonds has no history.
double LinearisedBonds::critical_stretch(const NodeVectors& u, int i, int j) const {
  const double own = lattice_->critical_stretch_at(i, j);
  if (lattice_->is_void(i, j)) return own;
  const double alpha = lattice_->material_at(i, j).material.alpha;
  if (alpha == 0.0) return own;
  double min = std::numeric_limits<double>::infinity();
  for (const Kept& bond : kept_)
    for (const int side : {0, 1}) {
      const int from_i = i - side * bond.a, from_j = j - side * bond.b;
      if (!lattice_->grid.contains(from_i, from_j) || !holds(from_i, from_j, bond)) continue;
      min = std::min(min, stretch_of(u, from_i, from_j, bond));
    }
  return std::isfinite(min) ? std::max(own - alpha * min, -1.0) : own;
}

std::vector<double> LinearisedBonds::critical_stretches(const NodeVectors& u) const {
  const Grid& grid = lattice_->grid;
  std::vector<double> critical(grid.nodes());
  for_rows(threads_, grid.ny, [&](int j) {
    for (int i = 0; i < grid.nx; ++i) critical[grid.index(i, j)] = critical_stretch(u, i, j);
  });
  return critical;
}

// A history may lower the critical stretch to 0 and below: the ratio must stay finite.
void LinearisedBonds::add_stretches_of_row(const NodeVectors& u,
                                           const std::vector<double>& critical, int j,
                                           Stretches& sum) const {
  constexpr double min_share = 1e-6;
  const Grid& grid = lattice_->grid;
  for (int i = 0; i < grid.nx; ++i)
    for (const Kept& bond : kept_) {
      const std::ptrdiff_t at = layout().at(i, j);
      if (!holds(i, j, bond)) continue;
      if (!lattice_->unbreakable.empty() && lattice_->unbreakable.holds(at, bond.bit)) continue;
      const double s0 = std::min(lattice_->critical_stretch_at(i, j),
                                 lattice_->critical_stretch_at(i + bond.a, j + bond.b));
      const double moved =
          std::min(critical[grid.index(i, j)], critical[grid.index(i + bond.a, j + bond.b)]);
      const double s = stretch_of(u, i, j, bond), ratio = s / std::max(moved, min_share * s0);
      sum.max = std::max(sum.max, ratio);
      if (ratio > 1.0)
        sum.beyond.push_back(
            {at, bond.bit, ratio,
             0.5 * strength_of(i, j, bond) * (s * s - s0 * s0) / bond.inverse_length});
    }
}

Stretches LinearisedBonds::stretches(const NodeVectors& u) const {
  const std::vector<double> critical = critical_stretches(u);
  std::vector<Stretches> of_row(static_cast<std::size_t>(lattice_->grid.ny));
  for_rows(threads_, lattice_->grid.ny, [&](int j) {
    add_stretches_of_row(u, critical, j, of_row[static_cast<std::size_t>(j)]);
  });
  Stretches all;
  for (const Stretches& row : of_row) {
    all.max = std::max(all.max, row.max);
    all.beyond.insert(all.beyond.end(), row.beyond.begin(), row.beyond.end());
  }
  return all;
}

}  // namespace hackle
