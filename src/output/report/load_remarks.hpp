// SPDX-License-Identifier: MIT
// Remarks on loads that a time step does not resolve.
#pragma once

#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

// The number of steps that a pulse must last, from half its rise to half its fall, for a run to
// resolve it.
inline constexpr double steps_a_swing = 3.0;

// Returns the shortest time, s, in which an amplitude rises and falls, or falls and rises, by at
// least a tenth of its largest factor between `begin` and `end`; infinite if it is constant,
// monotonic, or jumps. Nothing acts before time 0. Functions are sampled between the steps of `dt`,
// and more densely where they oscillate: events shorter than a 64th of a step may be missed. Throws
// what they throw.
double shortest_swing(const Amplitude& amplitude, double begin, double end, double dt);

// Returns a sentence for each load that comes and goes between steps until time `end`, s.
std::vector<std::string> load_remarks(const Simulation& simulation, double end);

// Returns a sentence for each temperature or support that suddenly breaks bonds until time `end`,
// s: their work is not known, because bonds break in the step that finds them. `fresh`: the loads
// have not acted yet, so they may act suddenly from now on.
std::vector<std::string> at_once_remarks(const Simulation& simulation, double end, bool fresh);

// Does the same for a sudden change of temperature: `before` is the previous thermal strain, by
// Grid::index or empty. Returns at most one sentence.
std::vector<std::string> shock_remarks(const Simulation& simulation,
                                       const std::vector<double>& before);

}  // namespace hackle
