// SPDX-License-Identifier: MIT
// The errors of a run against a reference, and all of them in one number.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/quantity.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {

// By quantity, in its unit; nothing of one that only the run or only the reference has.
using Errors = std::map<std::string, std::optional<double>>;

// Returns the errors in all quantities that the run or the reference has.
Errors errors_of(const Outcome& outcome, const Outcome& reference,
                 const std::vector<QuantityRow>& rows);

// Returns the error in a quantity that counts as one: of places, paths and lengths a horizon of the
// scene as written, 1 % of displacements and of the time of the run, 5 degrees, one branch, 1 % of
// the ledger, and 5 % of the reference's value of anything else.
double allowed_error(const QuantityRow& row, const SceneNumerics& scene, const Outcome& reference);

// Returns the root mean square of the errors over what is allowed, each at most 10, as also counts
// one that is nothing. 0 for no errors.
double score(const Errors& errors, const std::map<std::string, double>& allowed);

}  // namespace hackle
