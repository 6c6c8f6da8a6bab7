// SPDX-License-Identifier: MIT
#include "measure/crack_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hackle {
namespace {

constexpr double shortest_path = 1.0;  // horizons
constexpr double less = 0.75;          // of the damage, on both sides of a ridge
constexpr double breadth = 1.0;        // horizons, covered by a path on each side

// Takes paths out of a forest, the longest first.
class PathFinder {
 public:
  PathFinder(const CrackGrowth& growth, const CrackForest& forest)
      : growth_(&growth),
        forest_(&forest),
        path_(forest.size(), -1),
        position_(forest.size()),
        covered_(forest.size()) {}

  std::vector<SkeletonPath> paths() {
    std::vector<int> order(forest_->size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater(), [&](int n) { return forest_->way(n); });
    for (const int node : order)
      if (!covered_[at(node)]) follow_back(node);
    return std::move(paths_);
  }

 private:
  static std::size_t at(int node) { return static_cast<std::size_t>(node); }

  void follow_back(int end) {
    std::vector<int> nodes;
    int node = end;
    for (; node >= 0 && path_[at(node)] < 0; node = forest_->parent(node)) nodes.push_back(node);
    SkeletonPath path;
    if (node >= 0) {
      path.parent = path_[at(node)];
      path.leaves = position_[at(node)];
      nodes.push_back(node);
    }
    std::ranges::reverse(nodes);
    if (!counts(nodes)) return cover({end});
    const int number = static_cast<int>(paths_.size());
    for (const int one : nodes) {
      if (path_[at(one)] < 0) {
        path_[at(one)] = number;
        position_[at(one)] = path.nodes.size();
      }
      path.nodes.push_back(growth_->nodes()[at(one)]);
    }
    paths_.push_back(std::move(path));
    cover(nodes);
  }

  // Of the part that lies apart from all paths before.
  bool counts(const std::vector<int>& nodes) const {
    auto first = nodes.end();
    while (first != nodes.begin() && !covered_[at(*std::prev(first))]) --first;
    if (first == nodes.end()) return false;
    const double length = forest_->way(nodes.back()) - forest_->way(*first);
    const bool whole = first == nodes.begin();
    if (whole && forest_->tree(nodes.back()).at_start) return true;
    return length >= shortest_path * growth_->m() && is_ridge({first, nodes.end()});
  }

  // At most of its places damage is much less on both sides.
  bool is_ridge(const std::vector<int>& nodes) const {
    const int count = static_cast<int>(nodes.size());
    const int half = std::max(2, static_cast<int>(0.5 * growth_->m()));
    int ridges = 0;
    for (int k = 0; k < count; ++k) {
      const Vec2 from = forest_->place(nodes[at(std::max(0, k - half))]);
      const Vec2 to = forest_->place(nodes[at(std::min(count - 1, k + half))]);
      const Vec2 along = (to - from).normalized(), across(-along.y(), along.x());
      const Vec2 place = forest_->place(nodes[at(k)]);
      const double sides = std::max(side(place, across), side(place, -across));
      ridges += sides <= less * forest_->strength(nodes[at(k)]) ? 1 : 0;
    }
    return 2 * ridges >= count;
  }

  double side(const Vec2& place, const Vec2& across) const {
    double sum = 0.0;
    for (const double horizons : {0.8, 1.2}) {
      const auto [i, j] = node_at(place + horizons * growth_->m() * across);
      sum += 0.5 * mean_damage(*growth_, i, j);
    }
    return sum;
  }

  std::pair<int, int> node_at(const Vec2& place) const {
    const Grid& grid = growth_->grid();
    return {static_cast<int>(std::floor(place.x() + 0.5 * grid.nx)),
            static_cast<int>(std::floor(place.y() + 0.5 * grid.ny))};
  }

  void cover(const std::vector<int>& nodes) {
    const int radius = static_cast<int>(std::ceil(breadth * growth_->m()));
    double next = -1.0;
    for (const int node : nodes) {
      if (forest_->way(node) < next && node != nodes.back()) continue;
      next = forest_->way(node) + 0.25 * growth_->m();
      const auto [i, j] = node_at(forest_->place(node));
      for (int b = -radius; b <= radius; ++b)
        for (int a = -radius; a <= radius; ++a) {
          if (a * a + b * b > radius * radius) continue;
          const int other = forest_->at_place(i + a, j + b);
          if (other >= 0) covered_[at(other)] = 1;
        }
    }
  }

  const CrackGrowth* growth_;
  const CrackForest* forest_;
  std::vector<int> path_;
  std::vector<std::size_t> position_;
  std::vector<char> covered_;
  std::vector<SkeletonPath> paths_;
};

}  // namespace

CrackSkeleton skeleton(const CrackGrowth& growth) {
  if (growth.empty()) return {};
  const CrackForest forest(growth);
  return {PathFinder(growth, forest).paths(), forest.meetings()};
}

}  // namespace hackle
