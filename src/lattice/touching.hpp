// SPDX-License-Identifier: MIT
// How contacts and impacts limit the time step (src/lattice/README.md 4.5).
#pragma once

#include "lattice/symbol.hpp"
#include "scene/plate.hpp"

namespace hackle {

// How hard the lost bonds of a closed crack push, over what they did as bonds
// (solver/crack_faces.hpp).
inline constexpr double faces_bear = 1.2;

// How much stiffer they make the plate. Bonds: the energy of a face is that of the mean stretch of
// the lost bonds of a node, which is not above the mean of the energies of them all; so the plate
// with its faces is at most `faces_bear` times as stiff as with every bond in its place.
//
// Nodes: a bound of what they add to rho omega^2, in units of the stiffness c dx/m of a contact
// with the whole micromodulus (see Contact). A node has at most one contact straight ahead and two
// aslant, together as much as two, and both ends move: four times their stiffness. A disc adds its
// own stiffness to each node that it pushes, and as much again, by its recoil, as those nodes weigh
// over its mass; as many discs push one node as come near each other on their ways, straight on.
Touching touching_of(const Plate& plate, double dx);

// The share of a spacing that a disc may cross per step: it then pushes a node several times before
// the node is far inside.
inline constexpr double max_crossed = 0.1;

// The longest step for the discs of the plate, s; infinite when none flies. The plate is taken to
// start at rest or to move as one.
double longest_step_of_impact(const Plate& plate, double dx);

}  // namespace hackle
