// SPDX-License-Identifier: MIT
// How a stepper takes the tiles of a plate through a step, and how often it did so.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace hackle {

// How the bonds kept in a tile are computed (src/solver/README.md 4.4).
enum class Path : std::uint8_t {
  still,    // u and v are 0 in the tile and around it: nothing to do
  linear,   // every force in the tile and around it is linearised
  intact,   // all bonds are intact and none can break
  damaged,  // some are broken, no other can break
  careful,  // one may break, or is strained beyond the range of the series
};
inline constexpr std::array<std::string_view, 5> path_names{"still", "linear", "intact", "damaged",
                                                            "careful"};

// Tile-steps by path.
using PathCounts = std::array<std::int64_t, 5>;

}  // namespace hackle
