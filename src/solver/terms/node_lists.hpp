// SPDX-License-Identifier: MIT
// Loads give lists of nodes that may overlap; what acts is one list, in which each node stands
// once.
#pragma once

#include <algorithm>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle {

// All nodes of several lists, each once, by Grid::index.
template <class Lists>
std::vector<std::size_t> union_of(const Lists& lists, const Grid& grid) {
  std::vector<std::size_t> all;
  for (const auto& list : lists)
    for (const auto& node : list.nodes) all.push_back(grid.index(node.i, node.j));
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// Returns the positions of the nodes of a list among all nodes; both are ordered.
template <class Nodes>
std::vector<std::size_t> places_of(const Nodes& nodes, const Grid& grid,
                                   const std::vector<std::size_t>& all) {
  std::vector<std::size_t> at;
  at.reserve(nodes.size());
  std::size_t place = 0;
  for (const auto& node : nodes) {
    while (all[place] != grid.index(node.i, node.j)) ++place;
    at.push_back(place);
  }
  return at;
}

}  // namespace hackle
