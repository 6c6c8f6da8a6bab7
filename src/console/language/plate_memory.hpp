// SPDX-License-Identifier: MIT
// The memory of a plate outside its Lua object: it counts towards the script's limit.
#pragma once

#include <array>
#include <cstddef>

#include "scene/plate.hpp"

namespace hackle {

// A plate only ever grows, so each part is counted once.
class PlateMemory {
 public:
  // Returns the bytes added since the last call.
  std::size_t grown(const Plate& plate);
  // Returns the bytes added so far.
  std::size_t total() const { return total_; }

 private:
  std::array<std::size_t, 11> counted_{};
  std::size_t total_ = 0;
};

}  // namespace hackle
