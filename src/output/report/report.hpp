// SPDX-License-Identifier: MIT
// What a person wants to know about a simulation, in words.
#pragma once

#include <string>
#include <vector>

#include "output/report/summary.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Several lines, the last without an end of line.
std::string report(const Simulation& simulation, const Summary& summary);

// What a user should know before the run: a plate that is not a whole number of cells, constants
// that do not give the material's E or G0. One sentence each; mostly none.
std::vector<std::string> remarks(const Simulation& simulation);

}  // namespace hackle
