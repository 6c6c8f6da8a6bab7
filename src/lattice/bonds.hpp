// SPDX-License-Identifier: MIT
// The bonds of a lattice as bits, one per bond.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "lattice/node_layout.hpp"

namespace hackle {

// Bit k of a node says whether the k-th bond it keeps (see Family) is intact. Places are those of a
// NodeLayout. Stored as planes: word w of all places, then word w + 1.
class BondBits {
 public:
  BondBits() = default;
  BondBits(const NodeLayout& layout, int words)
      : plane_(layout.size()), words_(plane_ * static_cast<std::size_t>(words)) {}

  // Of the words of a former object, which were as many planes of this layout.
  BondBits(const NodeLayout& layout, std::vector<std::uint32_t> words)
      : plane_(layout.size()), words_(std::move(words)) {}

  bool holds(std::ptrdiff_t at, int bond) const {
    return (words_[index(at, bond)] & mask(bond)) != 0;
  }
  void set(std::ptrdiff_t at, int bond) { words_[index(at, bond)] |= mask(bond); }
  void clear(std::ptrdiff_t at, int bond) { words_[index(at, bond)] &= ~mask(bond); }
  void clear_all(std::ptrdiff_t at) {
    for (auto place = static_cast<std::size_t>(at); place < words_.size(); place += plane_)
      words_[place] = 0;
  }

  std::uint32_t word(std::ptrdiff_t at, int word) const {
    return words_[static_cast<std::size_t>(word) * plane_ + static_cast<std::size_t>(at)];
  }
  // Clears bits in one word of a place.
  void clear(std::ptrdiff_t at, int word, std::uint32_t bits) {
    words_[static_cast<std::size_t>(word) * plane_ + static_cast<std::size_t>(at)] &= ~bits;
  }

  // Returns the number of intact bonds.
  std::int64_t count() const {
    std::int64_t sum = 0;
    for (const std::uint32_t word : words_) sum += std::popcount(word);
    return sum;
  }

  std::size_t plane() const { return plane_; }  // words from one plane to the next
  bool empty() const { return words_.empty(); }
  const std::vector<std::uint32_t>& words() const { return words_; }

  friend bool operator==(const BondBits&, const BondBits&) = default;

 private:
  static std::uint32_t mask(int bond) { return std::uint32_t{1} << (bond & 31); }
  std::size_t index(std::ptrdiff_t at, int bond) const {
    return static_cast<std::size_t>(bond / 32) * plane_ + static_cast<std::size_t>(at);
  }

  std::size_t plane_ = 0;
  std::vector<std::uint32_t> words_;
};

}  // namespace hackle
