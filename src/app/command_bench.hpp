// SPDX-License-Identifier: MIT
// hackle bench
#pragma once

#include <string>

#include "solver/simulation.hpp"

namespace hackle {

struct BenchRequest {
  std::string peer = "auto";  // "lammps", "none", or "auto": LAMMPS if it is installed
  int rounds = 5;
  int nodes = 64000;
  bool ranks = false;  // under mpirun: measures the ranks instead
  Execution execution;
  bool json = false;
  bool quiet = false;
};

// Measures every configuration, and the peer, once per round, so that a machine that slows down
// affects all of them; prints medians over the rounds. Returns the exit code.
int command_bench(const BenchRequest& request);

}  // namespace hackle
