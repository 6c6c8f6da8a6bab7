// SPDX-License-Identifier: MIT
// What a circle leaves of the cell of a lattice node.
#pragma once

#include "scene/vec2.hpp"

namespace hackle {

struct CellPart {
  double area = 0.0;    // 0..1, of a cell of side 1
  Vec2 centroid{0, 0};  // of that part, from the centre of the circle
};

// The part of the cell centred at (a, b) that lies inside a circle of radius `radius` around
// (0, 0), integrated exactly. a, b >= 0 are whole and not both 0; all lengths are in cells. The
// centroid of a cell on an axis lies on the axis.
CellPart cell_inside_circle(int a, int b, double radius);

}  // namespace hackle
