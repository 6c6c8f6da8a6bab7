// SPDX-License-Identifier: MIT
#include "measure/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace hackle {
namespace {

// Returns the column and row of the node nearest to a place in m, which may lie off the plate.
Eigen::Vector2i nearest_node(const Grid& grid, const Vec2& place) {
  const Vec2 node = grid.from_centre(place) + 0.5 * Vec2(grid.nx - 1, grid.ny - 1);
  return {static_cast<int>(std::lround(node.x())), static_cast<int>(std::lround(node.y()))};
}

bool is_open(const View& view, const Vec2& place, const Vec2& normal) {
  const Grid& grid = view.lattice().grid;
  const Vec2 aside = 0.75 * grid.dx * normal;
  const Eigen::Vector2i one = nearest_node(grid, place - aside);
  const Eigen::Vector2i other = nearest_node(grid, place + aside);
  for (const Eigen::Vector2i& node : {one, other})
    if (!grid.contains(node.x(), node.y()) || view.lattice().is_void(node.x(), node.y()))
      return false;
  return !view.holds(one.x(), one.y(), other.x() - one.x(), other.y() - one.y());
}

// Returns how far, m, a crack is open behind its tip, which is only known to about a horizon.
double open_length(const View& view, const TipFrame& frame) {
  const double dx = view.lattice().grid.dx;
  double length = view.numerics().horizon_or_default();
  if (!is_open(view, frame.tip - length * frame.ahead, frame.normal())) return 0.0;
  while (is_open(view, frame.tip - length * frame.ahead, frame.normal())) length += 0.5 * dx;
  return length;
}

// What makes the plate differ from node to node.
class Makeup {
 public:
  Makeup(const View& view, const Vec2& ahead)
      : lattice_(view.lattice()),
        intact_(degrees(lattice_.grid, lattice_.family, view.state().bonds)),
        a_(static_cast<int>(std::lround(ahead.x()))),
        b_(static_cast<int>(std::lround(ahead.y()))),
        on_axis_(std::abs(a_) + std::abs(b_) == 1 && (ahead - Vec2(a_, b_)).norm() < 1e-9) {}

  bool lacks_at(int i, int j) const {
    return lattice_.is_void(i, j) || bonds(i, j) < lattice_.family.bonds() ||
           other_material(i, j, i + 1, j) || other_material(i, j, i, j + 1);
  }
  bool changes_at(int i, int j) const {
    if (lattice_.is_void(i, j)) return true;
    if (!on_axis_) return lacks_at(i, j);
    return changes(i, j, i + a_, j + b_) || changes(i, j, i - a_, j - b_);
  }

 private:
  int bonds(int i, int j) const {
    return lattice_.grid.contains(i, j) ? intact_[lattice_.grid.index(i, j)] : -1;
  }
  bool other_material(int i, int j, int k, int l) const {
    const Grid& grid = lattice_.grid;
    if (lattice_.material.empty() || !grid.contains(k, l)) return false;
    return lattice_.material[grid.index(i, j)] != lattice_.material[grid.index(k, l)];
  }
  bool changes(int i, int j, int k, int l) const {
    return bonds(i, j) != bonds(k, l) || other_material(i, j, k, l);
  }

  const Lattice& lattice_;
  std::vector<std::uint16_t> intact_;
  int a_, b_;
  bool on_axis_;
};

}  // namespace

std::optional<Clearance> clearance(const View& view, const TipFrame& frame) {
  const Grid& grid = view.lattice().grid;
  const double horizon = view.numerics().horizon_or_default();
  const double open = open_length(view, frame), beside = horizon + 2.0 * grid.dx;
  if (open == 0.0) return std::nullopt;
  const Eigen::Vector2i start = nearest_node(grid, frame.tip - open * frame.ahead);
  const Makeup makeup(view, frame.ahead);
  const double none = std::numeric_limits<double>::infinity();
  const double first = grid.contains(start.x(), start.y()) ? open - horizon : none;
  Clearance clear{first, first};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 local = frame.local(grid.position(i, j));
      const bool behind = local.x() < 0.0 && local.x() > -open - beside;
      const double distance = local.norm();
      if ((behind ? std::abs(local.y()) : distance) < beside) continue;
      if (distance < clear.along && makeup.changes_at(i, j)) clear.along = distance;
      if (distance < clear.all_round && makeup.lacks_at(i, j)) clear.all_round = distance;
    }
  clear.all_round = std::min(clear.all_round, clear.along);
  return clear;
}

}  // namespace hackle
