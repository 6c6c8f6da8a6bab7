// SPDX-License-Identifier: MIT
// What a user should know of loads that a time step does not resolve.
#pragma once

#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

// How many steps what comes and goes must last, from half its rise to half its fall, so that a run
// sees what it is.
inline constexpr double steps_a_swing = 3.0;

// The shortest time, s, for which an amplitude comes and goes, or goes and comes, by at least a
// tenth of its largest factor between `begin` and `end`; infinite for one that is constant, rises
// or falls for good, or jumps. Nothing acts before the time 0. Functions are asked between the
// steps of `dt`, and closer where they swing: what lasts for less than a 64th of a step may be
// missed. Throws what they throw.
double shortest_swing(const Amplitude& amplitude, double begin, double end, double dt);

// Loads that come and go between steps until the time `end`, s. One sentence each.
std::vector<std::string> load_remarks(const Simulation& simulation, double end);

// Temperatures and supports that break bonds at once until the time `end`, s: their work is not
// known, as bonds break in the step that finds them. `fresh`: the loads have not acted yet, so they
// may act at once from now on. One sentence each.
std::vector<std::string> at_once_remarks(const Simulation& simulation, double end, bool fresh);

// The same for what the temperature has done at once: `before` is the thermal strain that was, by
// Grid::index or empty. Nothing or one sentence.
std::vector<std::string> shock_remarks(const Simulation& simulation,
                                       const std::vector<double>& before);

}  // namespace hackle
