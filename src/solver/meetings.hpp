// SPDX-License-Identifier: MIT
// Places at which three or more of several lists meet. Of two terms a plain sum is the same in
// either order; those of more are to be summed exactly (exact_sum.hpp), so that what acts on a node
// does not depend on the order in which it was said.
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
