// SPDX-License-Identifier: MIT
// The strength of each node if strength is scattered. It has the same bits on every machine:
// counter-based noise and the functions of base/portable_math.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle {

// Returns the critical stretch over s0 per node, by Grid::index. The distribution has mean 1:
// Weibull, never below min_strength; or normal, cut off at 3 standard deviations (0.27 % lie
// beyond). The correlation is exp(-r^2/L^2), L the correlation length, from noise on a grid of L/2
// that is fixed to the lower left corner of the plate: every spacing has the same flaws. L below
// half a spacing counts as 0: the noise of nodes is then independent.
std::vector<float> strengths(const Scatter& scatter, const Grid& grid);

inline constexpr double min_strength = 0.01;

// Returns a standard normal random number for every seed and cell.
double normal_noise(std::int64_t seed, std::int64_t column, std::int64_t row);

}  // namespace hackle
