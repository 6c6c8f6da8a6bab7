// SPDX-License-Identifier: MIT
// Runs LAMMPS on the plate of the benchmark: `pair_style peri/pmb` on one core, in double
// precision.
#pragma once

#include <string>

#include "app/bench_deck.hpp"

namespace hackle {

// The values in LAMMPS's log.
struct LammpsRun {
  std::string version;  // "29 Sep 2021 - Update 2"
  int nodes = 0;
  double seconds = 0.0;    // of the steps alone
  double megabytes = 0.0;  // allocated by LAMMPS
  int steps = 0;

  double node_steps_per_second() const { return nodes * static_cast<double>(steps) / seconds; }
  double bytes_per_node() const { return megabytes * 1024.0 * 1024.0 / nodes; }
};

// Returns whether `lmp` is on the PATH.
bool lammps_is_installed();

// Returns the input deck. LAMMPS cannot cut bonds, so its plate has no crack and no no-fail zones:
// at any time nearly all bonds are intact, in its plate and in Hackle's. Everything else favours
// LAMMPS: its contact list is as short as the family and never rebuilt, and it prints nothing
// between first and last step.
std::string lammps_deck(const BenchDeck& deck, double alpha, int steps);

// Throws Error (run_failed) if the log lacks the line with the time.
LammpsRun read_lammps_log(const std::string& log);

// Throws Error (run_failed) with the last line of LAMMPS if it fails.
LammpsRun run_lammps(const BenchDeck& deck, double alpha, int steps);

}  // namespace hackle
