// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hackle {

// Returns the key of a member in a file: its name and unit, "stress_Pa", "rho_kg_m3", "alphaT_1_K".
// Angles have no unit.
std::string key_of(std::string_view name, std::string_view unit);

}  // namespace hackle
