// SPDX-License-Identifier: MIT
// What a sample of numbers tells of the quantity they were drawn from.
#pragma once

#include <span>

namespace hackle {

struct Statistic {
  int count = 0;  // of numbers
  double mean = 0.0;
  double sd = 0.0;  // standard deviation of the quantity, from count - 1 degrees of freedom
  double min = 0.0, max = 0.0;
  double low = 0.0, high = 0.0;  // the mean lies between them with 95 %, by Student's t
};

// All of it is 0 for no number; one number has neither a deviation nor an interval.
Statistic statistic_of(std::span<const double> numbers);

// Returns the number t that a variable of Student's distribution exceeds in absolute value with 5
// %; `freedom`, its degrees, is at least 1. Correct to 2e-4 (Abramowitz and Stegun, 26.7.5).
double student_95(int freedom);

}  // namespace hackle
