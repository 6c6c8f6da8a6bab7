// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/statics/linearised_bonds.hpp"

namespace hackle {

// Overstretched bonds within this share of the worst ratio break together; this may relieve the
// others.
inline constexpr double breaking_share = 0.9;

struct Breakage {
  std::vector<BrokenBond> broken_bonds;
  double excess = 0.0;  // Overstretched::excess of all: released energy
};

// Breaks the most overstretched of these bonds.
Breakage break_worst(const std::vector<Overstretched>& beyond, BondBits& bonds);

}  // namespace hackle
