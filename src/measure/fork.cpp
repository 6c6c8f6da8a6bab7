// SPDX-License-Identifier: MIT
#include "measure/fork.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include <Eigen/Eigenvalues>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

constexpr double shortest_branch = 1.0;  // horizons
constexpr double looked_at = 4.0;        // horizons along a branch, for its middle line

constexpr double unreached = std::numeric_limits<double>::infinity();

template <class Visit>
void for_neighbours(const Grid& grid, std::size_t node, Visit visit) {
  const auto columns = static_cast<std::size_t>(grid.nx);
  const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
  for (int b = -1; b <= 1; ++b)
    for (int a = -1; a <= 1; ++a)
      if ((a != 0 || b != 0) && grid.contains(i + a, j + b))
        visit(grid.index(i + a, j + b), a != 0 && b != 0 ? std::numbers::sqrt2 : 1.0);
}

// Path lengths in spacings along the band from the nearest of some nodes, by Grid::index.
class Ways {
 public:
  Ways(const Nodes& band, const Grid& grid)
      : band_(&band), grid_(&grid), way_(band.size(), unreached) {}

  // Returns the last node reached.
  std::size_t spread(const std::vector<std::size_t>& from) {
    using Stop = std::pair<double, std::size_t>;
    std::priority_queue<Stop, std::vector<Stop>, std::greater<>> next;
    for (const std::size_t node : from) {
      way_[node] = 0.0;
      next.push({0.0, node});
    }
    std::size_t last = from.empty() ? 0 : from.front();
    for (; !next.empty();) {
      const double way = next.top().first;
      const std::size_t node = next.top().second;
      next.pop();
      if (way > way_[node]) continue;
      last = node;
      for_neighbours(*grid_, node, [&](std::size_t other, double step) {
        if (!(*band_)[other] || way_[other] <= way + step) return;
        way_[other] = way + step;
        next.push({way + step, other});
      });
    }
    return last;
  }
  // Starts from the end of an unreached band that is farthest from `node`.
  void spread_from_end(std::size_t node) {
    Ways there(*band_, *grid_);
    spread({there.spread({node})});
  }
  double to(std::size_t node) const { return way_[node]; }

 private:
  const Nodes* band_;
  const Grid* grid_;
  std::vector<double> way_;
};

Ways ways_from_start(const Nodes& band, const Nodes& at_start, const Grid& grid) {
  std::vector<std::size_t> start;
  for (std::size_t node = 0; node < band.size(); ++node)
    if (band[node] && at_start[node]) start.push_back(node);
  Ways ways(band, grid);
  ways.spread(start);
  for (std::size_t node = 0; node < band.size(); ++node)
    if (band[node] && ways.to(node) == unreached) ways.spread_from_end(node);
  return ways;
}

struct Line {
  Vec2 point{0, 0};
  Vec2 direction{0, 0};
};

std::optional<Line> line_through(const std::vector<Vec2>& points) {
  if (points.size() < 3) return std::nullopt;
  Vec2 mean(0, 0);
  for (const Vec2& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& point : points) spread += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  return Line{mean, axes.eigenvectors().col(1)};
}

std::optional<Vec2> meeting(const Line& one, const Line& other) {
  const double slant = cross(one.direction, other.direction);
  if (std::abs(slant) < 0.05) return std::nullopt;
  return one.point + cross(other.point - one.point, other.direction) / slant * one.direction;
}

// Finds the branches of the bands by visiting the farthest nodes first: the nodes beyond some
// distance from the start form components, each a branch, and two of them merge at the node where
// they part.
class Branches {
 public:
  Branches(const Nodes& nodes, const Ways& ways, const Grid& grid, double m)
      : nodes_(&nodes),
        ways_(&ways),
        grid_(&grid),
        m_(m),
        parent_(nodes.size()),
        tip_(nodes.size()) {}

  std::vector<Vec2> forks() {
    std::vector<std::size_t> order;
    for (std::size_t node = 0; node < parent_.size(); ++node)
      if (ways_->to(node) != unreached) order.push_back(node);
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t n) { return ways_->to(n); });
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    std::vector<char> seen(parent_.size());
    std::vector<Vec2> found;
    for (const std::size_t node : order) {
      tip_[node] = ways_->to(node);
      seen[node] = 1;
      for_neighbours(*grid_, node, [&](std::size_t other, double) {
        if (seen[other]) join(node, other, found);
      });
    }
    std::ranges::sort(found, {}, [](const Vec2& place) { return place.x(); });
    return found;
  }

 private:
  std::size_t root(std::size_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }

  void join(std::size_t node, std::size_t other, std::vector<Vec2>& found) {
    const std::size_t one = root(node), two = root(other);
    if (one == two) return;
    const double here = ways_->to(node), min = shortest_branch * m_;
    if (here > 0.0 && tip_[one] - here > min && tip_[two] - here > min)
      found.push_back(place_of_fork(node, one, two));
    parent_[two] = one;
    tip_[one] = std::max(tip_[one], tip_[two]);
  }

  // Returns where they part, unless their middle lines give a better point.
  Vec2 place_of_fork(std::size_t node, std::size_t one, std::size_t two) {
    Vec2 parting = place(node);
    const auto first = line_through(middles(one, ways_->to(node)));
    const auto second = line_through(middles(two, ways_->to(node)));
    if (!first || !second) return parting;
    const auto meet = meeting(*first, *second);
    const double farthest = looked_at * m_ * grid_->dx;
    return meet && (*meet - parting).norm() < farthest ? *meet : parting;
  }

  // Returns the midpoints of the nodes on the crack, one per spacing along a branch.
  std::vector<Vec2> middles(std::size_t branch, double from) {
    const auto max = static_cast<std::size_t>(looked_at * m_) + 1;
    std::vector<Vec2> sums(max, Vec2(0, 0));
    std::vector<double> counts(max);
    for (std::size_t node = 0; node < parent_.size(); ++node) {
      const double along = ways_->to(node) - from;
      if (!(*nodes_)[node] || !(along > 0.0 && along < looked_at * m_)) continue;
      if (root(node) != branch || ways_->to(node) > tip_[branch] - 0.5 * m_) continue;
      sums[static_cast<std::size_t>(along)] += place(node);
      counts[static_cast<std::size_t>(along)] += 1.0;
    }
    std::vector<Vec2> result;
    for (std::size_t k = 0; k < max; ++k)
      if (counts[k] > 0.0) result.emplace_back(sums[k] / counts[k]);
    return result;
  }

  Vec2 place(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(grid_->nx);
    return grid_->position(static_cast<int>(node % columns), static_cast<int>(node / columns));
  }

  const Nodes* nodes_;
  const Ways* ways_;
  const Grid* grid_;
  double m_;
  std::vector<std::size_t> parent_;
  std::vector<double> tip_;  // distance to the farthest node of a branch, by its root
};

}  // namespace

std::vector<Vec2> forks(const Nodes& nodes, const Nodes& at_start, const Grid& grid, double m) {
  const Nodes band = close_gaps(nodes, grid, m);
  const Ways ways = ways_from_start(band, at_start, grid);
  return Branches(nodes, ways, grid, m).forks();
}

}  // namespace hackle
