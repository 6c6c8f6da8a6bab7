// SPDX-License-Identifier: MIT
// What the nodes have of rims and of the faces of cracks, for loads that act along them
// (src/lattice/README.md 7.4).
#pragma once

#include <string>
#include <vector>

#include "lattice/lattice.hpp"
#include "scene/loads/rim_part.hpp"

namespace hackle {

// What a node has of a rim.
struct RimShare {
  int i = 0;
  int j = 0;
  double length = 0.0;  // in spacings
  Vec2 normal{0, 0};    // into the material, times the length
  Vec2 middle{0, 0};    // m, of what it has
};

// Returns the shares of all nodes in the rims of this name, each node once, ordered by index. Parts
// of a rim beyond which there is no material, or that lie in another void, are left out. Their sum
// is the length of the rim, and that of their normals the integral of the normal, to two millionths
// of the radius.
std::vector<RimShare> shares_of_rims(const Plate& plate, const Lattice& lattice,
                                     const std::string& rim, const RimPart& angles);

// Returns the same for both faces of the cracks of this name: their normals add up to 0.
std::vector<RimShare> shares_of_cracks(const Plate& plate, const Lattice& lattice,
                                       const std::string& crack, const RimPart& angles);

}  // namespace hackle
