// SPDX-License-Identifier: MIT
// mpirun -n N hackle bench --ranks: how fast several ranks are, beside what is expected of them.
#pragma once

#include "app/command_bench.hpp"
#include "base/ranks/ranks.hpp"

namespace hackle {

// Measures, in alternating rounds, a step of the plate on all ranks and one of a slab alone, and
// what joins the ranks; prints them, the model of src/solver/README.md 10.6 and what it expects
// for more ranks. Called on all ranks; the first one prints. Returns the exit code.
int bench_ranks(const BenchRequest& request, Ranks& ranks);

}  // namespace hackle
