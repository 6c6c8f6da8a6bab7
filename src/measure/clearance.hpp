// SPDX-License-Identifier: MIT
// How far the plate around the tip of a crack is as the integrals of fracture mechanics presume.
#pragma once

#include <optional>

#include "measure/tip_frame.hpp"
#include "solver/view.hpp"

namespace hackle {

// Distances from a tip, m, infinite without anything in the way. The nodes within about a horizon
// of the open crack and of the tip do not count; a horizon from the other end of the crack does.
struct Clearance {
  // To the nearest node whose intact bonds, or material, differ from those of its neighbours along
  // the crack: J presumes that they do not. An edge that is parallel to a crack along an axis of
  // the lattice is not in the way; along a crack askew to the lattice it is.
  double along = 0.0;
  // To the nearest node that lacks a bond, or is of another material than a neighbour: Williams'
  // fields presume an endless plate.
  double all_round = 0.0;
};

// Returns nothing if no crack is open a horizon behind the tip.
std::optional<Clearance> clearance(const View& view, const TipFrame& frame);

}  // namespace hackle
