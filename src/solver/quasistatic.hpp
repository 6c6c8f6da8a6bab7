// SPDX-License-Identifier: MIT
// Loading so slow that the plate is at rest at every moment.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "solver/static_equilibrium.hpp"

namespace hackle {

struct QuasistaticOptions {
  double duration = 0.0;    // s, of the amplitudes of the loads; above 0
  int increments = 10;      // equal parts of the duration, >= 1
  double tolerance = 1e-6;  // of RelaxOptions
  // Called from time to time with the progress, 0..1, and where it stands; may throw.
  std::function<void(double fraction, int increment, int pass, std::int64_t broken)> progress;
};

struct QuasistaticResult {
  // How often the plate was brought to rest in each increment: 1 where nothing broke.
  std::vector<int> passes;
  std::int64_t iterations = 0;  // of conjugate gradients
  std::int64_t broken = 0;      // bonds
  // Whether the plate bears the loads to the end. If not, it came apart in the last increment of
  // `passes`: bonds are broken as far as equilibria were found, and a run goes on from there.
  bool bears = true;
  std::string why;  // what was then found
};

// Overstretched bonds within this share of the worst ratio break together; the others may be
// relieved by that.
inline constexpr double breaking_share = 0.9;

struct Breakage {
  std::vector<BrokenBond> broken_bonds;
  double excess = 0.0;  // Overstretched::excess of all: given off
};

// Breaks the worst of these bonds.
Breakage break_worst(const std::vector<Overstretched>& beyond, BondBits& bonds);

}  // namespace hackle
