// SPDX-License-Identifier: MIT
// hackle bench --accuracy: what a faster way to solve the benchmark's plate costs in accuracy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

// A way to solve the plate, and what it is compared with.
struct Trade {
  std::string name;
  Numerics numerics;
};

// What came of it. Times in s, places in m.
struct TradeResult {
  std::string name;
  std::int64_t nodes = 0;
  double seconds = 0.0;  // of solving the whole run
  double node_steps_per_second = 0.0;
  // Relative L2 difference of the displacements at trade_sample, before the first bond breaks: to
  // f64 without approximations on the same lattice with the default step, and to a lattice of half
  // the spacing and the same horizon.
  double to_exact = 0.0;
  double to_finer = 0.0;
  std::optional<double> first_bond;  // time at which a bond was first found broken
  std::optional<double> fork_time;   // at which two branches were first seen
  std::optional<double> fork_place;
  double tip_place = 0.0;   // at the end
  double residual = 0.0;    // of the energy ledger, over the work of the loads
  std::int64_t broken = 0;  // bonds
};

// The run, to 32 us, and the time of the comparison of displacements.
inline constexpr double trade_end = 32e-6;
inline constexpr double trade_sample = 5e-6;

// The trades worth knowing: arithmetic, step, fidelity, breaking rule, horizon, quadrature,
// spacing.
std::vector<Trade> trades();

// Solves the benchmark's plate that way, on one thread. Throws Error (interrupted) on Ctrl-C.
TradeResult measure_trade(const Trade& trade, InstructionSet set);

}  // namespace hackle
