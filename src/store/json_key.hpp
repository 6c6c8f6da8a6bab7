// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hackle {

// The key of a member in a file: its name and its unit, "stress_Pa", "rho_kg_m3", "alphaT_1_K".
// Angles are numbers.
std::string key_of(std::string_view name, std::string_view unit);

}  // namespace hackle
