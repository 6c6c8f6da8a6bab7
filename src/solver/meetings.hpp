// SPDX-License-Identifier: MIT
// Finds places where three or more of several lists meet. A plain sum of two terms is the same in
// either order; three or more must be summed exactly (exact_sum.hpp), so that the total on a node
// does not depend on the order of the loads (src/solver/README.md 6.2).
#pragma once

#include <cstddef>
#include <vector>

namespace hackle {

struct Meeting {
  struct Entry {
    std::size_t list = 0;
    std::size_t entry = 0;  // of the list
  };
  std::size_t place = 0;
  std::vector<Entry> entries;  // three at least
};

// Every list holds places, each below `places` and once; ordered by place.
std::vector<Meeting> find_meetings(const std::vector<const std::vector<std::size_t>*>& lists,
                                   std::size_t places);

}  // namespace hackle
