// SPDX-License-Identifier: MIT
// hackle bench --accuracy: the loss of accuracy of faster ways to solve the benchmark's plate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

// A way to solve the plate, and its reference.
struct Trade {
  std::string name;
  Numerics numerics;
};

// The result of a trade. Times in s, positions in m.
struct TradeResult {
  std::string name;
  std::int64_t nodes = 0;
  double seconds = 0.0;  // to solve the whole run
  double node_steps_per_second = 0.0;
  // Relative L2 difference of the displacements at trade_sample, before the first bond breaks: from
  // f64 without approximations on the same lattice with the default step, and from a lattice of
  // half the spacing with the same horizon.
  double to_exact = 0.0;
  double to_finer = 0.0;
  std::optional<double> first_bond;  // time at which a broken bond was first found
  std::optional<double> fork_time;   // time at which two branches were first seen
  std::optional<double> fork_place;
  double tip_place = 0.0;   // x of the tip at the end
  double residual = 0.0;    // of the energy ledger, relative to the work of the loads
  std::int64_t broken = 0;  // bonds
};

// The length of the run, 32 us, and the time at which displacements are compared.
inline constexpr double trade_end = 32e-6;
inline constexpr double trade_sample = 5e-6;

// Returns the trades worth knowing: arithmetic, step, fidelity, breaking rule, horizon, quadrature,
// spacing.
std::vector<Trade> trades();

// Solves the benchmark's plate in this way, on one thread. Throws Error (interrupted) on Ctrl-C.
TradeResult measure_trade(const Trade& trade, InstructionSet set);

}  // namespace hackle
