// SPDX-License-Identifier: MIT
// How strong each node is when strength differs from place to place. The same bits on every
// machine: noise by counting, functions of base/portable_math.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle {

// Per node, by Grid::index, the critical stretch over s0. The distribution has mean 1: Weibull,
// never below min_strength; or normal, cut off at 3 deviations (0.27 % lie beyond). Neighbours
// are correlated as exp(-r^2/L^2), L the correlation length, by noise on a grid of L/2 that is tied
// to the lower left corner of the plate: every spacing sees the same flaws. Below half a spacing L
// counts as 0: every node has noise of its own.
std::vector<float> strengths(const Scatter& scatter, const Grid& grid);

inline constexpr double min_strength = 0.01;

// A number of a standard normal distribution for every seed and cell.
double normal_noise(std::int64_t seed, std::int64_t column, std::int64_t row);

}  // namespace hackle
