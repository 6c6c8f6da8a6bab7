// SPDX-License-Identifier: MIT
// All that changes while a plate is solved: with the same plate and numerics, a simulation goes on
// from it with the same bits.
#pragma once

#include <optional>
#include <vector>

#include "lattice/load_map.hpp"
#include "solver/aim.hpp"
#include "solver/broken_bond.hpp"
#include "solver/divergence.hpp"
#include "solver/state.hpp"
#include "solver/statics/rest.hpp"

namespace hackle {

struct Snapshot {
  State state;
  Aim aim;                               // to where it was on its way
  std::vector<LoadedNode> borne;         // the loads under which it last came to rest
  std::optional<double> widened_at;      // s, when f32 became f64
  double max_energy = 0.0;               // see Divergence
  double solve_seconds = 0.0;            // wall time of all steps
  std::vector<BrokenBond> broken_bonds;  // in the last step
  std::optional<SlowCourse> course;      // of slow loading that has not come to its end
};

}  // namespace hackle
