// SPDX-License-Identifier: MIT
// mpirun -n N hackle bench --ranks: how fast several ranks are, beside what is expected of them.
#pragma once

#include "base/ranks/ranks.hpp"
#include "solver/simulation.hpp"

namespace hackle {

struct RankBenchRequest {
  int rounds = 5;
  int nodes = 64000;  // of the whole plate
  Execution execution;
  bool json = false;
};

// Measures, in alternating rounds, a step of the plate on all ranks and one of a slab alone, and
// what joins the ranks; prints them, the model of src/solver/README.md 10.6 and what it expects
// for more ranks. Called on all ranks; the first one prints. Returns the exit code.
int bench_ranks(const RankBenchRequest& request, Ranks& ranks);

}  // namespace hackle
