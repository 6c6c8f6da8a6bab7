// SPDX-License-Identifier: MIT
// What a scene needs beyond bonds of one cold material, and the memory that takes. The estimate
// before a run, the engine and the report all use this one rule (src/lattice/README.md 8.1).
#pragma once

#include <limits>

#include "lattice/lattice.hpp"
#include "lattice/numerics.hpp"

namespace hackle {

struct Needs {
  bool kinds = false;      // every node has a material of its own: there are inclusions or cut-outs
  bool mixed = false;      // materials differ in stiffness, density, s0 or alpha
  bool history = false;    // the alpha of some material is not 0
  bool heated = false;     // the temperature changes
  bool zones = false;      // some bonds never break
  bool scattered = false;  // strength differs from node to node

  // What a kernel has to look at: bits of bonds that never break, thresholds by node.
  bool guarded() const { return mixed || heated || zones; }
  bool varied() const { return mixed || heated || history || scattered; }
};

// Before a lattice is built. Requires a family: min_m <= m <= max_m.
Needs needs_of(const Plate& plate, const Numerics& numerics);
// The same of a lattice that has been built.
Needs needs_of(const Lattice& lattice, bool heated);

// A plate of more columns or rows has no lattice.
inline constexpr double max_columns = 0.25 * std::numeric_limits<int>::max();

struct Memory {
  double kept = 0.0;     // bytes that state, lattice and engine hold: Simulation::bytes()
  double loads = 0.0;    // upper bound: lists of loaded and prescribed nodes
  double passing = 0.0;  // peak of what set-up and summary hold for a while
  double statics = 0.0;  // what coming to rest holds for a while, not in all()
  double all() const { return kept + loads + passing; }
};

// Covers all that grows with the plate. Left out: what an f32 run takes when it goes over to f64,
// nodes in contact, pictures and files. Requires a family.
Memory memory_of(const Plate& plate, const Numerics& numerics);

}  // namespace hackle
