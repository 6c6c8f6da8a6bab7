// SPDX-License-Identifier: MIT
#include "study/observed_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hackle {
namespace {

constexpr double safety_of_three = 1.25, safety_of_two = 3.0;
constexpr double least_order = 0.1;                    // below it changes do not shrink
constexpr double lowest_used = 0.5, highest_used = 2;  // of p in an uncertainty

// Solves (r32^p - 1) r21^p / (r21^p - 1) = e32/e21 for p. The left side grows with p: a bisection
// finds what a fixed point may miss.
std::optional<double> order_of(double e32, double e21, double r32, double r21) {
  const auto excess = [&](double p) {
    const double fine = std::pow(r21, p);
    return (std::pow(r32, p) - 1.0) * fine / (fine - 1.0) - e32 / e21;
  };
  double low = -20.0, high = 20.0;
  if (excess(low) > 0.0 || excess(high) < 0.0) return std::nullopt;
  for (int k = 0; k < 80; ++k) {
    // At 0 the expression is 0/0; the middle of no step lands on it.
    const double middle = low + 0.49 * (high - low);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double uncertainty_of(double change, double ratio, double order, double safety) {
  return safety * change / (std::pow(ratio, std::clamp(order, lowest_used, highest_used)) - 1.0);
}

void judge_three(const LevelChange& former, const LevelChange& last, double r32, double r21,
                 ObservedOrder& result) {
  if (former.sign * last.sign < 0 && former.size > 0.0 && last.size > 0.0) {
    // The value lies between the last two, if at all.
    result.trend = Trend::oscillates;
    if (last.size < former.size) result.uncertainty = safety_of_three * last.size;
    return;
  }
  if (last.size == 0.0) {
    result.trend = Trend::converges;
    result.uncertainty = 0.0;
    return;
  }
  result.order = former.size > 0.0 ? order_of(former.size, last.size, r32, r21) : std::nullopt;
  result.trend = result.order && *result.order >= least_order ? Trend::converges : Trend::diverges;
  if (result.trend == Trend::converges)
    result.uncertainty = uncertainty_of(last.size, r21, *result.order, safety_of_three);
}

// Of a change between levels k and k + 1.
bool is_none(const LevelChange& change, std::span<const double> resolutions, std::size_t k) {
  const double floor = resolutions.empty() ? 0.0 : std::max(resolutions[k], resolutions[k + 1]);
  return change.size <= floor * (1.0 + 1e-9);
}

}  // namespace

ObservedOrder observed_order(std::span<const double> sizes, std::span<const LevelChange> changes,
                             std::span<const double> resolutions) {
  ObservedOrder result;
  if (changes.empty()) return result;
  const std::size_t fine = sizes.size() - 1;
  const LevelChange& last = changes.back();
  const double r21 = sizes[fine - 1] / sizes[fine];
  result.per_halving = last.size * std::log(2.0) / std::log(r21);
  if (changes.size() < 2) {
    result.uncertainty = uncertainty_of(last.size, r21, 1.0, safety_of_two);
  } else if (is_none(changes[fine - 1], resolutions, fine - 1) &&
             is_none(changes[fine - 2], resolutions, fine - 2)) {
    result.trend = Trend::constant;
    result.uncertainty = safety_of_three * last.size;
  } else {
    judge_three(changes[fine - 2], last, sizes[fine - 2] / sizes[fine - 1], r21, result);
  }
  if (result.uncertainty && !resolutions.empty())
    result.uncertainty = std::max(*result.uncertainty, safety_of_three * resolutions.back());
  return result;
}

double richardson(double coarse, double fine, double ratio, double order) {
  return fine + (fine - coarse) / (std::pow(ratio, order) - 1.0);
}

std::optional<double> fitted_exponent(std::span<const double> sizes,
                                      std::span<const double> values) {
  const auto is_positive = [](double value) { return value > 0.0; };
  if (sizes.size() != values.size() || values.size() < 2 ||
      !std::ranges::all_of(values, is_positive) || !std::ranges::all_of(sizes, is_positive))
    return std::nullopt;
  const auto count = static_cast<double>(sizes.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double u = std::log(sizes[k]), v = std::log(values[k]);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  const double spread = count * xx - x * x;
  if (!(spread > 0.0)) return std::nullopt;
  return (count * xy - x * y) / spread;
}

}  // namespace hackle
