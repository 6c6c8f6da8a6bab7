// SPDX-License-Identifier: MIT
#include "output/export/lammps_types.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"

namespace hackle {
namespace {

constexpr int max_types = 2000;  // LAMMPS keeps tables of all pairs

std::pair<int, int> ordered(int one, int other) {
  return {std::min(one, other), std::max(one, other)};
}

// Gives the nodes at cuts their types, one after another: to each the first whose relations to all
// other types stay what they are, and which is not told apart from it by a node near both.
class TypeGiver {
 public:
  explicit TypeGiver(const LammpsScene& scene)
      : scene_(scene), at_cut_(scene.grid.nodes(), 0), nodes_(scene.grid.nodes()) {
    types_.of_node.assign(nodes_, 1);
    types_.strong.push_back(0);
    give_zone_type();
    for (const auto& [one, other] : scene.cuts) {
      at_cut_[one] = at_cut_[other] = 1;
      cuts_.insert(key(one, other));
    }
    first_of_cuts_ = static_cast<int>(types_.strong.size()) + 1;
  }

  LammpsTypes give() {
    std::vector<std::size_t> order;
    for (std::size_t node = 0; node < nodes_; ++node)
      if (at_cut_[node] != 0) order.push_back(node), types_.of_node[node] = 0;
    for (const std::size_t node : order) {
      throw_if_interrupted();
      types_.of_node[node] = type_for(node);
    }
    for (const auto& [pair, joined] : joined_)
      if (!joined) types_.apart.insert(pair);
    return types_;
  }

 private:
  // Nodes of zones that are away from cuts share a type.
  void give_zone_type() {
    if (std::ranges::find(scene_.strong, 1) == scene_.strong.end()) return;
    types_.strong.push_back(1);
    for (std::size_t node = 0; node < nodes_; ++node)
      if (scene_.strong[node] != 0) types_.of_node[node] = 2;
  }

  std::uint64_t key(std::size_t one, std::size_t other) const {
    return std::min(one, other) * nodes_ + std::max(one, other);
  }
  bool is_joined(std::size_t one, std::size_t other) const {
    return !cuts_.contains(key(one, other));
  }
  char is_strong(std::size_t node) const {
    return scene_.strong.empty() ? char{0} : scene_.strong[node];
  }

  // Calls visit(other, joined) for the other nodes at cuts within the horizon.
  template <class Visit>
  void for_each_near(std::size_t node, const Visit& visit) const {
    const Grid& grid = scene_.grid;
    const auto reach = static_cast<int>(std::floor(scene_.m + 1e-9));
    const auto columns = static_cast<std::size_t>(grid.nx);
    const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
    for (int b = -reach; b <= reach; ++b)
      for (int a = -reach; a <= reach; ++a) {
        const bool is_near = a * a + b * b <= scene_.m * scene_.m + 1e-6 && (a != 0 || b != 0);
        if (!is_near || !grid.contains(i + a, j + b)) continue;
        const std::size_t other = grid.index(i + a, j + b);
        if (at_cut_[other] != 0) visit(other, is_joined(node, other));
      }
  }

  // Returns the types of nodes from which a node near both tells this one apart.
  std::set<int> told_apart(std::size_t node) const {
    std::set<int> types;
    for_each_near(node, [&](std::size_t near, bool joined) {
      for_each_near(near, [&](std::size_t other, bool is_other_joined) {
        if (is_other_joined != joined && types_.of_node[other] != 0)
          types.insert(types_.of_node[other]);
      });
    });
    return types;
  }

  bool suits(int type, std::size_t node) const {
    if (types_.strong[static_cast<std::size_t>(type) - 1] != is_strong(node)) return false;
    bool fits = true;
    for_each_near(node, [&](std::size_t other, bool joined) {
      if (types_.of_node[other] == 0) return;
      const auto known = joined_.find(ordered(type, types_.of_node[other]));
      fits = fits && (known == joined_.end() || known->second == joined);
    });
    return fits;
  }

  int type_for(std::size_t node) {
    const std::set<int> others = told_apart(node);
    int type = first_of_cuts_;
    const int end = static_cast<int>(types_.strong.size()) + 1;
    while (type < end && (others.contains(type) || !suits(type, node))) ++type;
    if (type == end) types_.strong.push_back(is_strong(node));
    if (type > max_types)
      throw Error(
          ErrorKind::refused,
          fmt::format("export: its cracks and cut-outs need over {} types of atoms", max_types),
          "export a plate with fewer or straighter ones, or on a coarser lattice");
    for_each_near(node, [&](std::size_t other, bool joined) {
      if (types_.of_node[other] != 0) joined_[ordered(type, types_.of_node[other])] = joined;
    });
    return type;
  }

  const LammpsScene& scene_;
  std::vector<char> at_cut_;
  std::size_t nodes_;
  std::unordered_set<std::uint64_t> cuts_;
  LammpsTypes types_;  // of_node is 0 for nodes at cuts that have none yet
  int first_of_cuts_ = 0;
  std::map<std::pair<int, int>, bool> joined_;  // known relations of types
};

}  // namespace

LammpsTypes lammps_types(const LammpsScene& scene) {
  return TypeGiver(scene).give();
}

}  // namespace hackle
