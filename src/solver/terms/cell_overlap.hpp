// SPDX-License-Identifier: MIT
// The overlap of rigid bodies with the cell of a node, the square of one spacing around it that
// pictures show: a body touches the plate where it is drawn. Lengths are in dx.
#pragma once

#include "lattice/lattice.hpp"
#include "solver/state.hpp"

namespace hackle {

// Nodes whose cells come within this many spacings of a body are checked in every step.
inline constexpr double watched = 2.0;

// Returns the present position of a node, from the centre of the lattice.
Vec2 place_now(const Grid& grid, const State& state, int i, int j);

// Returns the vector from the centre of a disc to the nearest point of the cell of a node.
Vec2 way_to_cell(const Vec2& node, const Vec2& centre);

// Return how far the cell of a node reaches into a disc or a box, as a vector that points out of
// it; 0 if they do not overlap. `half` is half the size of the box; out of a box leads the axis
// along which the way is shorter, along y if both are alike.
Vec2 overlap_with_disc(const Vec2& node, const Vec2& centre, double radius);
Vec2 overlap_with_box(const Vec2& node, const Vec2& centre, const Vec2& half);

// Returns the force on a node of the plate's own material per overlap, in units of rho dx^2/dt^2.
double strength_of_push(const Plate& plate, const Lattice& lattice, double dt);

}  // namespace hackle
