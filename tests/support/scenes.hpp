// SPDX-License-Identifier: MIT
// Scenes that several tests share.
#pragma once

#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle::test {

inline Material duran50() {
  return {"Duran 50 glass", 65e9, 2235.0, 0.2, 204.0, 0.0, 0.0, 136.5e3};
}

// Makes a plate of `nx` by `ny` cells of 0.5 mm without cracks or loads.
inline Plate bare_plate(int nx, int ny) {
  Plate plate;
  plate.width = nx * 0.5e-3;
  plate.height = ny * 0.5e-3;
  plate.material = duran50();
  return plate;
}

// Makes the paper's sample 1: 100 x 40 mm, an edge crack of 50 mm at mid-height, step tractions on
// both long edges, along which bonds cannot break over one horizon.
inline Plate edge_crack(double stress) {
  Plate plate;
  plate.width = 0.1;
  plate.height = 0.04;
  plate.material = duran50();
  plate.cracks.push_back({{0.0, 0.02}, {0.05, 0.02}, Born::broken});
  plate.loads.tractions.push_back({Edge::top, {0.0, stress}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -stress}});
  plate.no_fail.push_back(strip(plate, Edge::top, 2e-3));
  plate.no_fail.push_back(strip(plate, Edge::bottom, 2e-3));
  return plate;
}

inline Numerics numerics(double spacing = 0.5e-3, double horizon = 2e-3) {
  Numerics numerics;
  numerics.spacing = spacing;
  numerics.horizon = horizon;
  return numerics;
}

}  // namespace hackle::test
