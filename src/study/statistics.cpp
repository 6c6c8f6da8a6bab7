// SPDX-License-Identifier: MIT
#include "study/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hackle {

double student_95(int freedom) {
  // Of few degrees the expansion is poor.
  constexpr std::array exact{12.7062, 4.30265, 3.18245, 2.77645, 2.57058, 2.44691};
  if (freedom <= static_cast<int>(exact.size()))
    return exact[static_cast<std::size_t>(freedom - 1)];
  constexpr double z = 1.959963985;
  constexpr double z2 = z * z;
  const double n = freedom;
  const double first = (z2 + 1.0) / 4.0;
  const double second = ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double third = (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  const double fourth =
      ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) / 92160.0;
  return z * (1.0 + (first + (second + (third + fourth / n) / n) / n) / n);
}

Statistic statistic_of(std::span<const double> numbers) {
  Statistic all{.count = static_cast<int>(numbers.size())};
  if (numbers.empty()) return all;
  const double n = static_cast<double>(numbers.size());
  const auto [least, most] = std::ranges::minmax(numbers);
  all.min = least;
  all.max = most;
  // Rounding must not move the mean of equal numbers.
  all.mean = std::clamp(std::accumulate(numbers.begin(), numbers.end(), 0.0) / n, least, most);
  all.low = all.high = all.mean;
  if (numbers.size() < 2) return all;
  double squares = 0.0;
  for (const double number : numbers) squares += (number - all.mean) * (number - all.mean);
  all.sd = std::sqrt(squares / (n - 1.0));
  const double half = student_95(all.count - 1) * all.sd / std::sqrt(n);
  all.low -= half;
  all.high += half;
  return all;
}

}  // namespace hackle
