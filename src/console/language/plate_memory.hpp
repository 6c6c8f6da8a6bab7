// SPDX-License-Identifier: MIT
// The memory that a plate takes beside its object in Lua: it counts towards the script's.
#pragma once

#include <array>
#include <cstddef>

#include "scene/plate.hpp"

namespace hackle {

// Parts are only ever added to a plate, so each is looked at once.
class PlateMemory {
 public:
  // Bytes that were added since the last call.
  std::size_t grown(const Plate& plate);
  // Bytes that were added so far.
  std::size_t total() const { return total_; }

 private:
  std::array<std::size_t, 10> counted_{};
  std::size_t total_ = 0;
};

}  // namespace hackle
