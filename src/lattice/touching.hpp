// SPDX-License-Identifier: MIT
// The effect of contacts, impacts and springs on the limit of the time step
// (src/lattice/README.md 4.5).
#pragma once

#include <limits>
#include <string_view>

#include "lattice/symbol.hpp"
#include "scene/plate.hpp"

namespace hackle {

// The stiffness of the faces of a closed crack, relative to that of the lost bonds
// (solver/terms/crack_faces.hpp).
inline constexpr double faces_bear = 1.2;

// What drag leaves of the step limit: that of absorbing edges (solver/terms/absorbing_edges.cpp),
// and friction, which takes at most half of a node's velocity in a step
// (src/lattice/README.md 4.7).
inline constexpr double left_by_absorber = 0.93;
inline constexpr double left_by_friction = 0.85;

// Computes how much stiffer contacts and impacts make the plate. Bonds: the energy of a face is
// that of the mean stretch of a node's lost bonds, which is at most the mean of their energies; so
// the plate with its faces is at most `faces_bear` times as stiff as with every bond intact.
//
// Nodes: a bound on the addition to rho omega^2, in units of the stiffness c dx/m of a contact with
// the full micromodulus (see Contact). A node has at most one contact straight ahead and two
// diagonal ones, which together count as two, and both ends move: four times their stiffness. A
// disc adds its own stiffness to each node that it pushes and, by its recoil, as much again times
// the mass of those nodes over its own; the number of discs that push one node is the number that
// come near each other on their straight paths. Rollers and platens do the same; they recoil where
// a force leads them.
Touching touching_of(const Plate& plate, double dx);

// The largest share of a spacing that a rigid body may cross per step: it then pushes a node
// several times before the node is deep inside.
inline constexpr double max_crossed = 0.1;

// The longest step for the impactors, rollers and platens of a plate, s, and the one it is due to.
struct StepOfBodies {
  double longest = std::numeric_limits<double>::infinity();
  std::string_view who;
};

// The plate is assumed to start at rest or to move as one. Bodies that are led by a force or by a
// function of time do not count.
StepOfBodies longest_step_of_bodies(const Plate& plate, double dx);

}  // namespace hackle
