// SPDX-License-Identifier: MIT
// What loads and supports do while a plate goes from one place to another, at rest there, and what
// it gives off on the way.
#pragma once

#include "solver/node_vectors.hpp"

namespace hackle {

// A plate at a moment: displacements in dx; force densities of its bonds and loads on every node,
// in c dx2 with the micromodulus c of its own material.
struct Posture {
  NodeVectors u, pull, load;
};

// J/m in units of c dx5.
struct StaticWork {
  // Of loads, and of the reactions of supports, which are what bonds and loads leave on led nodes:
  // force times displacement by the trapezoidal rule. Exact while forces are linear in u.
  double external = 0.0;
  // Of what was out of balance on mobile nodes at the beginning and is not at the end: what would
  // have become motion. 0 where the plate sets out from rest and its bonds all hold.
  double released = 0.0;
};

// `mobile` is 1 along the axes where a node is free, 0 where it is led.
StaticWork work_between(const NodeLayout& layout, const Posture& before, const Posture& after,
                        const NodeVectors& mobile);

}  // namespace hackle
