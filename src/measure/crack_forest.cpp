// SPDX-License-Identifier: MIT
#include "measure/crack_forest.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace hackle {
namespace {

constexpr int reach_of_link = 2;  // dx: a crack may leave out a node
constexpr double not_reached = std::numeric_limits<double>::infinity();

}  // namespace

double mean_damage(const CrackGrowth& growth, int i, int j) {
  double sum = 0.0;
  for (int b = -1; b <= 1; ++b)
    for (int a = -1; a <= 1; ++a) sum += growth.damage(i + a, j + b);
  return sum / 9.0;
}

double CrackForest::Tree::extent() const {
  return std::hypot(max_x - min_x, max_y - min_y);
}

CrackForest::CrackForest(const CrackGrowth& growth)
    : growth_(&growth), index_(growth.grid().nodes(), -1) {
  for (int b = -reach_of_link; b <= reach_of_link; ++b)
    for (int a = -reach_of_link; a <= reach_of_link; ++a)
      if (a != 0 || b != 0) links_.push_back({a, b, std::hypot(a, b)});
  const std::vector<std::size_t>& nodes = growth.nodes();
  const auto columns = static_cast<std::size_t>(growth.grid().nx);
  for (const std::size_t node : nodes) {
    const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
    index_[node] = static_cast<std::int32_t>(places_.size());
    places_.push_back(growth.grid().from_centre(i, j));
    strength_.push_back(mean_damage(growth, i, j));
  }
  way_.assign(nodes.size(), 0.0);
  cost_.assign(nodes.size(), not_reached);
  parent_.assign(nodes.size(), -1);
  tree_.assign(nodes.size(), -1);
  grown_.assign(nodes.size(), 0);
  open_.assign(nodes.size(), 0);
  for (std::size_t first = 0, end = 0; first < nodes.size(); first = end) {
    while (end < nodes.size() && growth.arrival(nodes[end]) == growth.arrival(nodes[first])) ++end;
    grow(first, end);
  }
}

int CrackForest::at_place(int i, int j) const {
  return growth_->grid().contains(i, j) ? index_[growth_->grid().index(i, j)] : -1;
}

template <class Visit>
void CrackForest::for_neighbours(int node, Visit visit) const {
  const std::size_t where = growth_->nodes()[at(node)];
  const auto columns = static_cast<std::size_t>(growth_->grid().nx);
  const int i = static_cast<int>(where % columns), j = static_cast<int>(where / columns);
  for (const Link& link : links_) {
    const int other = at_place(i + link.a, j + link.b);
    if (other >= 0 && grown_[at(other)]) visit(other, link.length);
  }
}

void CrackForest::set_tree(int node, int tree) {
  tree_[at(node)] = tree;
  Tree& of = trees_[at(tree)];
  const Vec2& place = places_[at(node)];
  if (of.members.empty()) {
    of.min_x = of.max_x = place.x();
    of.min_y = of.max_y = place.y();
  }
  of.min_x = std::min(of.min_x, place.x());
  of.max_x = std::max(of.max_x, place.x());
  of.min_y = std::min(of.min_y, place.y());
  of.max_y = std::max(of.max_y, place.y());
  of.members.push_back(node);
  of.at_start =
      of.at_start || growth_->arrival(growth_->nodes()[at(node)]) == CrackGrowth::at_start;
}

// The way to a node of this moment costs less where damage is more.
bool CrackForest::relax(int node, int from, double length) {
  constexpr double side_of_crack = 0.5;
  const double weak = 2.0 * side_of_crack / (strength_[at(node)] + strength_[at(from)]);
  const double before = open_[at(from)] ? cost_[at(from)] : 0.0;
  const double cost = before + length * weak * weak * weak;
  if (!(cost < cost_[at(node)])) return false;
  cost_[at(node)] = cost;
  parent_[at(node)] = from;
  way_[at(node)] = way_[at(from)] + length;
  return true;
}

void CrackForest::relax_from_neighbours(int node, std::vector<int>& reached) {
  bool better = false;
  for_neighbours(node, [&](int other, double length) {
    if (tree_[at(other)] >= 0 && !open_[at(other)]) better = relax(node, other, length) || better;
  });
  if (better) reached.push_back(node);
}

// Dijkstra's algorithm among the open nodes, from some that have a cost.
void CrackForest::spread(const std::vector<int>& from) {
  using Stop = std::pair<double, int>;
  std::priority_queue<Stop, std::vector<Stop>, std::greater<>> next;
  for (const int node : from) next.push({cost_[at(node)], node});
  while (!next.empty()) {
    const auto [cost, node] = next.top();
    next.pop();
    if (cost > cost_[at(node)]) continue;
    if (parent_[at(node)] >= 0) tree_[at(node)] = tree_[at(parent_[at(node)])];
    const int here = node;
    for_neighbours(here, [&](int other, double length) {
      if (open_[at(other)] && relax(other, here, length)) next.push({cost_[at(other)], other});
    });
  }
}

// Returns the open nodes without a tree that hang together with a node.
std::vector<int> CrackForest::connected(int node) {
  std::vector<int> members{node};
  open_[at(node)] = 2;
  for (std::size_t k = 0; k < members.size(); ++k)
    for_neighbours(members[k], [&](int other, double) {
      if (open_[at(other)] != 1 || tree_[at(other)] >= 0) return;
      open_[at(other)] = 2;
      members.push_back(other);
    });
  return members;
}

// Lets a tree without number grow from a root; returns the node that is the farthest from it.
int CrackForest::sweep(int root, const std::vector<int>& members) {
  for (const int node : members) {
    cost_[at(node)] = not_reached;
    parent_[at(node)] = -1;
  }
  cost_[at(root)] = way_[at(root)] = 0.0;
  spread({root});
  int farthest = root;
  for (const int node : members)
    if (way_[at(node)] > way_[at(farthest)]) farthest = node;
  return farthest;
}

// A speck begins where damage is most. Of what was found at full length nobody knows where it
// began: at an end, one at the rim of the plate rather than another.
int CrackForest::root_of(const std::vector<int>& members) {
  const auto strongest =
      std::ranges::max_element(members, {}, [&](int n) { return strength_[at(n)]; });
  const int one = sweep(*strongest, members);
  if (way_[at(one)] <= 2.0 * growth_->m()) return *strongest;
  const int other = sweep(one, members);
  const auto depth = [&](int node) {
    const Vec2& place = places_[at(node)];
    return std::min(0.5 * growth_->grid().nx - std::abs(place.x()),
                    0.5 * growth_->grid().ny - std::abs(place.y()));
  };
  return depth(other) < depth(one) ? other : one;
}

void CrackForest::plant(int node) {
  const std::vector<int> members = connected(node);
  const int root = root_of(members);
  trees_.emplace_back();
  met_.emplace_back();
  sweep(root, members);
  for (const int member : members) set_tree(member, static_cast<int>(trees_.size()) - 1);
}

void CrackForest::grow(std::size_t first, std::size_t end) {
  std::vector<int> reached;
  for (std::size_t k = first; k < end; ++k) grown_[k] = open_[k] = 1;
  for (std::size_t k = first; k < end; ++k) relax_from_neighbours(static_cast<int>(k), reached);
  spread(reached);
  for (std::size_t k = first; k < end; ++k)
    if (tree_[k] >= 0) set_tree(static_cast<int>(k), tree_[k]);
  for (std::size_t k = first; k < end; ++k)
    if (tree_[k] < 0) plant(static_cast<int>(k));
  for (std::size_t k = first; k < end; ++k) open_[k] = 0;
  meet(first, end);
}

void CrackForest::absorb(int tree) {
  const std::vector<int> members = std::exchange(trees_[at(tree)].members, {});
  for (const int node : members) {
    tree_[at(node)] = parent_[at(node)] = -1;
    cost_[at(node)] = not_reached;
    open_[at(node)] = 1;
  }
  std::vector<int> reached;
  for (const int node : members) relax_from_neighbours(node, reached);
  spread(reached);
  for (const int node : members) open_[at(node)] = 0;
  for (const int node : members) set_tree(node, tree_[at(node)]);
}

void CrackForest::meet(std::size_t first, std::size_t end) {
  for (std::size_t k = first; k < end; ++k) {
    const int node = static_cast<int>(k);
    std::vector<int> near;
    for_neighbours(node, [&](int other, double) { near.push_back(other); });
    for (const int other : near) {
      const int one = tree_[k], two = tree_[at(other)];
      if (one == two) continue;
      const bool first_is_smaller = trees_[at(one)].extent() < trees_[at(two)].extent();
      const int smaller = first_is_smaller ? one : two;
      if (trees_[at(smaller)].extent() < growth_->m() && !trees_[at(smaller)].at_start) {
        absorb(smaller);
      } else if (std::ranges::find(met_[at(one)], two) == met_[at(one)].end()) {
        met_[at(one)].push_back(two);
        met_[at(two)].push_back(one);
        meetings_.push_back({growth_->nodes()[k], growth_->nodes()[at(other)],
                             growth_->arrival(growth_->nodes()[k])});
      }
    }
  }
}

}  // namespace hackle
