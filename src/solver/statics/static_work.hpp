// SPDX-License-Identifier: MIT
// The work of loads and supports between two equilibria of a plate, and the energy released on the
// way (src/solver/README.md 8.5).
#pragma once

#include "solver/node_vectors.hpp"

namespace hackle {

// A configuration of the plate: displacements in dx; force densities of its bonds and loads on
// every node, in c dx2 with the micromodulus c of its own material.
struct Posture {
  NodeVectors u, pull, load;
};

// J/m in units of c dx5.
struct StaticWork {
  // Work of loads and of the reactions of supports, which balance bonds and loads on prescribed
  // nodes: force times displacement by the trapezoidal rule. Exact while forces are linear in u.
  double external = 0.0;
  // Work of the initial residual forces on mobile nodes: it would have become motion. 0 if the
  // plate starts from equilibrium and all bonds hold.
  double released = 0.0;
};

// `mobile` is 1 along the axes where a node is free, 0 where it is prescribed.
StaticWork work_between(const NodeLayout& layout, const Posture& before, const Posture& after,
                        const NodeVectors& mobile);

}  // namespace hackle
