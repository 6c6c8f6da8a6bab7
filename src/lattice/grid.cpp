// SPDX-License-Identifier: MIT
#include "lattice/grid.hpp"

#include <cmath>

namespace hackle {

Grid make_grid(const Plate& plate, double dx) {
  Grid grid;
  grid.nx = static_cast<int>(std::lround(plate.width / dx));
  grid.ny = static_cast<int>(std::lround(plate.height / dx));
  grid.dx = dx;
  grid.centre = {0.5 * plate.width, 0.5 * plate.height};
  return grid;
}

}  // namespace hackle
