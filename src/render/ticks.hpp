// SPDX-License-Identifier: MIT
// Neat numbers along an axis.
#pragma once

#include <string>
#include <vector>

namespace hackle {

// Multiples of 1, 2, 2.5 or 5 times a power of ten from `least` to `most` (least < most), in order,
// so many that they make at most so many intervals (at least 1).
std::vector<double> neat_values(double least, double most, int intervals);

// The same, but enough of them to reach beyond both.
std::vector<double> enclosing_values(double least, double most, int intervals);

// Powers of ten from `least` to `most` (0 < least < most), every one or every so many, as above.
std::vector<double> decades(double least, double most, int intervals);

// Four digits of each, more where two would read alike; "−20", "10⁻⁵".
std::vector<std::string> tick_texts(const std::vector<double>& values);

}  // namespace hackle
