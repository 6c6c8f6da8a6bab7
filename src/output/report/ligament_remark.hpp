// SPDX-License-Identifier: MIT
// A remark on thin parts of a plate, which free surfaces make too soft.
#pragma once

#include <optional>
#include <string>

#include "solver/simulation.hpp"

namespace hackle {

// From this width on, in horizons, surfaces make a bar softer by less than 1 %
// (src/lattice/README.md 3.10).
inline constexpr double min_ligament = 20.0;

// Returns the width of the narrowest part, m: of the plate and the areas of its outlines, between
// cut-outs and edges, between two cut-outs, and ahead of a crack that is longer than what is left
// of the plate there, up to its edge. Shapes count as the boxes around them, so rims that are round
// do not seem thin where they end. 0 where a cut-out or area is thinner than a spacing.
double narrowest(const Plate& plate);

// Returns a sentence on it if it is under min_ligament and nothing corrects it.
std::optional<std::string> ligament_remark(const Simulation& simulation);

}  // namespace hackle
