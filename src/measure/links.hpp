// SPDX-License-Identifier: MIT
// Which nearest neighbours still hang together: where a displaced plate opens.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/view.hpp"

namespace hackle {

// Bits of the bonds of a node to its nearest neighbours to the right and above; those to the left
// and below are kept by these neighbours.
struct Link {
  static constexpr std::uint8_t right = 1, above_right = 2, above = 4, above_left = 8;
};

// Those that hold, by Grid::index.
std::vector<std::uint8_t> links(const View& view);

}  // namespace hackle
