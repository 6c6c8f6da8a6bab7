// SPDX-License-Identifier: MIT
// Values of quantities for a person, for a table of numbers, and for JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "study/quantity.hpp"

namespace hackle {

// "22.4 us", "(65.8, 20) mm", "3 paths"; "-" if it was not found.
std::string text_of(const QuantityValue& value, const QuantityRow& row);

// Returns a number in SI units, a pair of a place in m, the lines of paths in m, the vectors of a
// field; null if it was not found.
nlohmann::ordered_json json_of(const QuantityValue& value);

// "fork.time_s", "branches": the name with the unit, for the head of a column of numbers.
std::string column_of(const QuantityRow& row);

}  // namespace hackle
