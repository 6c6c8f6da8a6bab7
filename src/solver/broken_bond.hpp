// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace hackle {

// An overstretched bond.
struct BrokenBond {
  std::ptrdiff_t at = 0;  // place of the node that keeps it
  int word = 0;
  std::uint32_t bit = 0;
};

}  // namespace hackle
