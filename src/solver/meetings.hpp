// SPDX-License-Identifier: MIT
// Finds places that occur in three or more of several lists. A plain sum of two terms is the same
// in either order; three or more must be summed exactly (exact_sum.hpp), so that the total on a
// node does not depend on the order of the loads (src/solver/README.md 6.2).
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
  std::vector<Entry> entries;  // at least three
};

// Every list contains places below `places`, each at most once, in ascending order.
std::vector<Meeting> find_meetings(const std::vector<const std::vector<std::size_t>*>& lists,
                                   std::size_t places);

}  // namespace hackle
