// SPDX-License-Identifier: MIT
// The nearest neighbours that are still joined by bonds: a displaced plate opens between the
// others.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/view.hpp"

namespace hackle {

// Bits of the bonds of a node to its nearest neighbours to the right and above; those neighbours to
// the left and below keep the others.
struct Link {
  static constexpr std::uint8_t right = 1, above_right = 2, above = 4, above_left = 8;
};

// Returns the bits of intact bonds, by Grid::index.
std::vector<std::uint8_t> links(const View& view);

}  // namespace hackle
