// SPDX-License-Identifier: MIT
// simulate(p, { within = 0.5*mm }): the spacing is chosen by an error budget.
#pragma once

#include <optional>

#include "console/schema/schema.hpp"
#include "output/report/error_budget.hpp"
#include "scene/plate.hpp"

struct lua_State;

namespace hackle {

class Session;

// [-0, +0] If the table at `index` says `within`, replaces it by a copy with the chosen spacing and
// precision, and returns what was chosen: for a script that is run by trials of it, else by the
// calibration. --set simulate.spacing comes first: nothing is chosen then, so trials, which set it,
// try nothing themselves. Throws what budget_by_trials throws.
std::optional<ErrorBudget> spend_budget(lua_State* L, int index, const Plate& plate,
                                        const Session& session);

inline constexpr Option within_option{
    .name = "within",
    .unit = "m",
    .range = above(0.0),
    .alternative = true,
    .sentence =
        "Instead of spacing, which is then the largest one allowed: takes the cheapest one "
        "that is expected to keep the paths of cracks this near to those of half of it."};
inline constexpr Option verify_option{
    .name = "verify",
    .type = OptionType::flag,
    .fallback = "false",
    .sentence = "With within: also runs half the spacing, and reports the measured distance."};

}  // namespace hackle
