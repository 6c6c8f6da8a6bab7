// SPDX-License-Identifier: MIT
#include "solver/statics/breakage.hpp"

#include <algorithm>

namespace hackle {

Breakage break_worst(const std::vector<Overstretched>& beyond, BondBits& bonds) {
  double max = 0.0;
  for (const Overstretched& bond : beyond) max = std::max(max, bond.ratio);
  Breakage broken;
  for (const Overstretched& bond : beyond) {
    if (bond.ratio < breaking_share * max) continue;
    bonds.clear(bond.at, bond.bit);
    broken.broken_bonds.push_back({bond.at, bond.bit / 32, std::uint32_t{1} << (bond.bit % 32)});
    broken.excess += bond.excess;
  }
  return broken;
}

}  // namespace hackle
