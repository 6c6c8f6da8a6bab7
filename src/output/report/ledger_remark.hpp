// SPDX-License-Identifier: MIT
// What a user should know of a ledger of energy that does not close.
#pragma once

#include <optional>
#include <string>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// A ledger whose residual is a larger share of its largest entry is remarked on.
inline constexpr double max_residual = 0.05;

// The residual over the largest entry; 0 where all are 0.
double residual_share(const Energy& energy);

// That too much is missing or too much there, why this may be, and what to do about it; nothing
// where the ledger closes, or where all of it is less than what rounding and heat alone leave.
// `at_once` says whether a load was remarked on that acts at once (shock_remarks).
std::optional<std::string> ledger_remark(const Simulation& simulation, const Energy& energy,
                                         bool at_once = false);

}  // namespace hackle
