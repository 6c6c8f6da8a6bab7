// SPDX-License-Identifier: MIT
// The remark on an energy ledger that does not close.
#pragma once

#include <optional>
#include <string>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// A residual above this share of the largest entry is remarked on.
inline constexpr double max_residual = 0.05;

// Returns the residual over the largest entry; 0 if all entries are 0.
double residual_share(const Energy& energy);

// Returns a remark that energy is missing or in excess, with possible causes and remedies; nothing
// if the ledger closes, or if all energy is less than the effect of rounding and heat alone.
// `at_once` tells whether a sudden load was remarked on (shock_remarks).
std::optional<std::string> ledger_remark(const Simulation& simulation, const Energy& energy,
                                         bool at_once = false);

}  // namespace hackle
