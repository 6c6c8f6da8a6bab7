// SPDX-License-Identifier: MIT
// LAMMPS on the plate of the benchmark: `pair_style peri/pmb` on one core, in double precision.
#pragma once

#include <string>

#include "app/bench_deck.hpp"

namespace hackle {

// What LAMMPS says in its log.
struct LammpsRun {
  std::string version;  // "29 Sep 2021 - Update 2"
  int nodes = 0;
  double seconds = 0.0;    // of the steps alone
  double megabytes = 0.0;  // that it allocated
  int steps = 0;

  double node_steps_per_second() const { return nodes * static_cast<double>(steps) / seconds; }
  double bytes_per_node() const { return megabytes * 1024.0 * 1024.0 / nodes; }
};

// Whether `lmp` is on the PATH.
bool lammps_is_installed();

// The input deck. LAMMPS cannot cut bonds, so its plate has no crack and no no-fail zones: at any
// time nearly all bonds hold, in its plate and in Hackle's. Everything else favours LAMMPS: its
// list of contacts is as short as the family and never built again, and it prints nothing between
// first and last step.
std::string lammps_deck(const BenchDeck& deck, double alpha, int steps);

// Throws Error (run_failed) when the log lacks the line that tells the time.
LammpsRun read_lammps_log(const std::string& log);

// Throws Error (run_failed) with the last line of LAMMPS when it fails.
LammpsRun run_lammps(const BenchDeck& deck, double alpha, int steps);

}  // namespace hackle
