// SPDX-License-Identifier: MIT
#include "solver/cpu/tiles.hpp"

#include <algorithm>

namespace hackle {

std::vector<int> tile_rows(int ny, int reach) {
  const int height = reach <= 8 ? 8 : 16;
  // Rows of tiles have full height from both ends; the rest in the middle becomes one or two rows
  // of tiles.
  const int each_side = std::max(0, (ny / height - 1) / 2);
  std::vector<int> first;
  first.reserve(2 * static_cast<std::size_t>(each_side) + 3);
  for (int k = 0; k < each_side; ++k) first.push_back(k * height);
  const int left = ny - 2 * each_side * height;
  first.push_back(each_side * height);
  if (left >= 2 * height && left % 2 == 0) first.push_back(each_side * height + left / 2);
  for (int k = each_side; k > 0; --k) first.push_back(ny - k * height);
  first.push_back(ny);
  return first;
}

}  // namespace hackle
