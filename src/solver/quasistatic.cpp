// SPDX-License-Identifier: MIT
#include "solver/quasistatic.hpp"

#include <algorithm>

namespace hackle {

std::int64_t break_worst(const std::vector<Overstretched>& beyond, BondBits& bonds) {
  double most = 0.0;
  for (const Overstretched& bond : beyond) most = std::max(most, bond.ratio);
  std::int64_t broken = 0;
  for (const Overstretched& bond : beyond) {
    if (bond.ratio < breaking_share * most) continue;
    bonds.clear(bond.at, bond.bit);
    ++broken;
  }
  return broken;
}

}  // namespace hackle
