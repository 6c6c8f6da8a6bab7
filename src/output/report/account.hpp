// SPDX-License-Identifier: MIT
// What a run did, in plain sentences: what broke, when and where, or why nothing did, and how far
// its numbers can be trusted.
#pragma once

#include <string>
#include <vector>

#include "measure/crack_graph.hpp"
#include "measure/crack_growth.hpp"
#include "output/report/summary.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Returns at least one sentence. `growth` has followed the run, and `graph` is made of it; what it
// has not seen is said to have come earlier. Visits every bond.
std::vector<std::string> account_of(const Simulation& simulation, const Summary& summary,
                                    const CrackGrowth& growth, const CrackGraph& graph);

}  // namespace hackle
