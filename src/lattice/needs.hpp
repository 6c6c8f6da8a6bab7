// SPDX-License-Identifier: MIT
// The features a scene needs beyond bonds of one cold material, and their memory. The estimate
// before a run, the engine and the report all use this one rule (src/lattice/README.md 8.1).
#pragma once

#include <limits>

#include "lattice/lattice.hpp"
#include "lattice/numerics.hpp"

namespace hackle {

struct Needs {
  bool kinds = false;      // each node stores its material: there are inclusions or cut-outs
  bool mixed = false;      // nodes differ in stiffness, density, s0 or alpha
  bool surfaced = false;   // nodes near a surface are stiffer; implies mixed
  bool history = false;    // some material has an alpha above 0
  bool heated = false;     // temperature changes
  bool zones = false;      // some bonds never break
  bool scattered = false;  // strength varies from node to node

  // Whether a kernel must check for unbreakable bonds, or use thresholds per node.
  bool guarded() const { return mixed || heated || zones; }
  bool varied() const { return mixed || heated || history || scattered; }
};

// Determines the needs before a lattice is built. Requires a family: min_m <= m <= max_m.
Needs needs_of(const Plate& plate, const Numerics& numerics);
// Determines the needs of a built lattice.
Needs needs_of(const Lattice& lattice, bool heated);

// A plate with more columns or rows cannot have a lattice.
inline constexpr double max_columns = 0.25 * std::numeric_limits<int>::max();

struct Memory {
  double kept = 0.0;     // bytes held by state, lattice and engine: Simulation::bytes()
  double loads = 0.0;    // upper bound: lists of loaded and prescribed nodes
  double passing = 0.0;  // temporary peak of set-up and summary
  double statics = 0.0;  // temporary, for static equilibrium; not in all()
  double all() const { return kept + loads + passing; }
};

// Estimates all memory that grows with the plate. Not included: the change of an f32 run to f64,
// nodes in contact, pictures and files. Requires a family.
Memory memory_of(const Plate& plate, const Numerics& numerics);

}  // namespace hackle
