// SPDX-License-Identifier: MIT
// The memory layout of node values.
#pragma once

#include <cstddef>

namespace hackle {

// Rows of nodes with ghost columns between them, so that a kernel may read and compute whole groups
// of columns. Ghosts have no bonds. If nx is even, the midline of the lattice is the border between
// two groups, so groups are mirror images of each other.
struct NodeLayout {
  static constexpr int group = 16;  // columns; also the largest distance that a kernel may read

  int nx = 0;
  int ny = 0;

  int groups() const { return (shift() + nx + group - 1) / group; }  // per row
  int first_column() const { return -shift(); }  // of the first group; node 0 or a ghost
  std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(groups() + 1) * group; }
  // Returns the place of column i of row j. at(first_column(), j) is a multiple of `group`.
  std::ptrdiff_t at(int i, int j) const { return j * stride() + group + shift() + i; }
  std::size_t size() const { return static_cast<std::size_t>(ny * stride() + group); }

  friend bool operator==(const NodeLayout&, const NodeLayout&) = default;

 private:
  int shift() const { return (group - (nx / 2) % group) % group; }
};

}  // namespace hackle
