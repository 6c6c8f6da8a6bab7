// SPDX-License-Identifier: MIT
// A quantity over the plate at one time, for pictures and files.
#pragma once

#include <string>
#include <vector>

#include "scene/shapes/box.hpp"
#include "solver/view.hpp"

namespace hackle {

// `components` values per node (1 or 2), node by node in the order of Grid::index, in SI units.
struct Field {
  std::string name;  // "damage"
  std::string unit;  // "" for a pure number, else "m", "m/s"
  int components = 1;
  std::vector<float> values;
};

// Returns the share of a node's initial bonds that are broken, 0..1; 0 for a node without any. A
// straight crack shows as 0.4 to 0.5 on its two sides.
Field damage(const View& view);
// Returns the damage by the cracks of the scene, before anything breaks.
Field damage_at_start(const View& view);
// Returns the damage of one node.
double damage_of(const View& view, int i, int j);
// Returns the change of temperature of one node, K; 0 where the material does not expand.
double temperature_of(const View& view, int i, int j);
Field displacement(const View& view);  // m, components x and y; 0 where void
Field velocity(const View& view);      // m/s, components x and y

// A rigid disc, m.
struct Circle {
  Vec2 centre{0, 0};
  double radius = 0.0;
};
// Returns where the impactors and rollers are.
std::vector<Circle> round_bodies(const View& view);
// Returns where the platens are, m.
std::vector<Box> platens(const View& view);

}  // namespace hackle
