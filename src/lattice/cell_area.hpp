// SPDX-License-Identifier: MIT
// The part of a lattice cell that lies inside a circle.
#pragma once

#include "scene/vec2.hpp"

namespace hackle {

struct CellPart {
  double area = 0.0;    // 0..1, of a cell of side 1
  Vec2 centroid{0, 0};  // of the part, relative to the centre of the circle
};

// Computes, in closed form, the part of the cell centred at (a, b) that lies inside a circle of
// radius `radius` around (0, 0). a, b >= 0 are integers and not both 0; all lengths are in cells.
// The area is exact to about 1e-13. The centroid lies in the cell, on the axis if the cell does,
// and is exact to about 1e-11 over the area. Exchanging a and b exchanges x and y to the last bit.
CellPart cell_inside_circle(int a, int b, double radius);

}  // namespace hackle
