// SPDX-License-Identifier: MIT
// One bit for each directed bond of each node.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace hackle {

// Bit k of node n says whether its bond to the k-th offset of the family holds. Kept as planes:
// word w of all nodes, then word w + 1. Both ends of a bond have their own bit; they always agree.
class BondBits {
 public:
  BondBits() = default;
  BondBits(std::size_t nodes, int words)
      : nodes_(nodes), bits_(nodes * static_cast<std::size_t>(words)) {}

  bool holds(std::size_t node, int bond) const { return (word(node, bond) >> (bond & 63)) & 1U; }
  void set(std::size_t node, int bond) { word(node, bond) |= mask(bond); }
  void clear(std::size_t node, int bond) { word(node, bond) &= ~mask(bond); }

  // Bonds of the node that hold.
  int count(std::size_t node) const {
    int sum = 0;
    for (std::size_t at = node; at < bits_.size(); at += nodes_) sum += std::popcount(bits_[at]);
    return sum;
  }
  // Directed bonds that hold; every bond counts twice.
  std::int64_t count() const {
    std::int64_t sum = 0;
    for (const std::uint64_t word : bits_) sum += std::popcount(word);
    return sum;
  }

  std::size_t nodes() const { return nodes_; }
  bool empty() const { return bits_.empty(); }
  std::vector<std::uint64_t>& planes() { return bits_; }
  const std::vector<std::uint64_t>& planes() const { return bits_; }

  friend bool operator==(const BondBits&, const BondBits&) = default;

 private:
  static std::uint64_t mask(int bond) { return std::uint64_t{1} << (bond & 63); }
  std::uint64_t& word(std::size_t node, int bond) {
    return bits_[static_cast<std::size_t>(bond / 64) * nodes_ + node];
  }
  const std::uint64_t& word(std::size_t node, int bond) const {
    return bits_[static_cast<std::size_t>(bond / 64) * nodes_ + node];
  }

  std::size_t nodes_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace hackle
