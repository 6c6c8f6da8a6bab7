// SPDX-License-Identifier: MIT
// Where a crack that runs along x has come to, and where it forks.
#pragma once

#include <optional>

#include "lattice/grid.hpp"
#include "measure/field.hpp"

namespace hackle {

// Damage above which a node lies on a crack: a straight crack has 0.4 to 0.5 on its sides.
inline constexpr float on_crack = 0.35F;

// Separate runs of nodes on a crack in one column of nodes.
int bands(const Field& damage, const Grid& grid, int column);

// The most bands in any column.
int most_bands(const Field& damage, const Grid& grid);

// The place, in m, of the first column from the left with two bands or more.
std::optional<double> fork_place(const Field& damage, const Grid& grid);

// The farthest place on a crack, in m; 0 when there is none.
double tip_place(const Field& damage, const Grid& grid);

}  // namespace hackle
