// SPDX-License-Identifier: MIT
// What contacts and impacts ask of the time step.
#pragma once

#include "scene/plate.hpp"

namespace hackle {

// How much stiffer they make the nodes, in units of the stiffness c dx/m of a touch by the whole
// micromodulus (see Contact): bounds what they add to rho omega^2. Of contacts a node may have one
// straight ahead and two aslant, as much as two, and both ends move: four times their stiffness. A
// disc adds its own to each node that it pushes, and by its recoil as much again as those nodes
// weigh of its mass, which is more; two discs at most push one node.
double touching_stiffness(const Plate& plate, double dx);

// Of a spacing, what a disc may cross in a step: nodes that it meets are then pushed several times
// before they are far inside.
inline constexpr double most_crossed = 0.1;

// The longest step for the discs of the plate, s, which starts at rest or as one; without limit
// when none flies.
double longest_step_of_impact(const Plate& plate, double dx);

}  // namespace hackle
