// SPDX-License-Identifier: MIT
// Runs LAMMPS on the plate of the benchmark: `pair_style peri/pmb` on one core, in double
// precision.
#pragma once

#include <string>

#include "app/bench_deck.hpp"
#include "output/export/lammps_scene.hpp"

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

// Returns the plate of the benchmark for LAMMPS: without the crack, so that all atoms are of one
// type, and without no-fail zones. At any time nearly all bonds are intact, in its plate and in
// Hackle's.
LammpsScene bench_scene(const BenchDeck& deck, double alpha);

// Throws Error (run_failed) if the log lacks the line with the time.
LammpsRun read_lammps_log(const std::string& log);

// Runs LAMMPS on bench_scene(). All else favours it: its list of contacts is as short as the family
// and never made again, and it prints nothing between first and last step. Throws Error
// (run_failed) with the last line of LAMMPS if it fails.
LammpsRun run_lammps(const BenchDeck& deck, double alpha, int steps);

}  // namespace hackle
