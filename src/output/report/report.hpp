// SPDX-License-Identifier: MIT
// The report on a simulation, in words.
#pragma once

#include <string>
#include <vector>

#include "output/report/summary.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Returns several lines, the last without a line end.
std::string report(const Simulation& simulation, const Summary& summary);

// Returns remarks before the run: on a plate that is not a whole number of cells, and on constants
// that do not give the material's E or G0. One sentence each; usually none.
std::vector<std::string> remarks(const Simulation& simulation);

}  // namespace hackle
