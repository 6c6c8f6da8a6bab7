// SPDX-License-Identifier: MIT
// Round numbers along an axis.
#pragma once

#include <string>
#include <vector>

#include "base/units.hpp"

namespace hackle {

// Returns multiples of 1, 2, 2.5 or 5 times a power of ten from `least` to `most` (least < most),
// ascending, as many as make at most `intervals` intervals (at least 1).
std::vector<double> neat_values(double min, double max, int intervals);

// Returns such values that are whole numbers: multiples of 1, 2 or 5 times a power of ten.
std::vector<double> whole_values(double min, double max, int intervals);

// Returns such values, extended to reach beyond both ends.
std::vector<double> enclosing_values(double min, double max, int intervals);

// Returns powers of ten from `least` to `most` (0 < least < most), every one or every n-th, with at
// most as many intervals as above.
std::vector<double> decades(double min, double max, int intervals);

// Returns the texts of ticks with four digits, or more if two would read alike; "−20", "10⁻⁵".
std::vector<std::string> tick_texts(const std::vector<double>& values);

// Returns the unit of numbers at an axis that reaches this far. J/m and N/m take the prefixes of J
// and N.
PrefixedUnit axis_unit(double size, const std::string& unit);

}  // namespace hackle
