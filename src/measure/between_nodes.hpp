// SPDX-License-Identifier: MIT
// Values between nodes.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "solver/view.hpp"

namespace hackle {

// The nodes from which a place takes its values, and their shares, which add up to 1.
struct Surrounding {
  struct Share {
    int i = 0, j = 0;
    double weight = 0.0;
  };
  std::array<Share, 4> shares{};
  int count = 0;
};

// Returns the nodes around a place, m, of the undeformed plate. Where all four corners of the cell
// between nodes that holds it are joined by intact bonds to the nearest of them, the place is
// interpolated bilinearly, and up to the rim extrapolated, which is exact for fields that are
// linear in x and y. Else only the corners count that are joined to the nearest, which lie on its
// side of a crack: the others' shares go to them in proportion. Returns nothing in a hole or off
// the plate.
std::optional<Surrounding> surrounding(const View& view, const Vec2& place);

// The same of nodes that are known otherwise.
struct Joints {
  const Grid& grid;
  std::function<bool(int i, int j)> is_there;  // false in a hole
  // Whether an intact bond joins (i, j) to (i + column, j + row), one of its eight neighbours.
  std::function<bool(int i, int j, int column, int row)> joined;
};
std::optional<Surrounding> surrounding(const Joints& joints, const Vec2& place);

template <class Value>
auto interpolated(const Surrounding& nodes, const Value& value_of) {
  auto sum = decltype(value_of(0, 0))(nodes.shares[0].weight *
                                      value_of(nodes.shares[0].i, nodes.shares[0].j));
  for (int k = 1; k < nodes.count; ++k) {
    const auto& share = nodes.shares[static_cast<std::size_t>(k)];
    sum += share.weight * value_of(share.i, share.j);
  }
  return sum;
}

}  // namespace hackle
