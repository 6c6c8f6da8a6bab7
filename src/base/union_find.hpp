// SPDX-License-Identifier: MIT
// Sets that grow together: which things are connected when pairs of them are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hackle {

class UnionFind {
 public:
  // Each of `count` things in a set of its own.
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  void unite(std::size_t one, std::size_t other) {
    const std::size_t a = first_of(one), b = first_of(other);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  // The least of the set of `thing`. Halves the path there.
  std::size_t first_of(std::size_t thing) {
    while (parent_[thing] != thing) thing = parent_[thing] = parent_[parent_[thing]];
    return thing;
  }

  // The same of every thing.
  std::vector<std::size_t> firsts() {
    for (std::size_t thing = 0; thing < parent_.size(); ++thing) parent_[thing] = first_of(thing);
    return parent_;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace hackle
