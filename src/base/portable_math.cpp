// SPDX-License-Identifier: MIT
#include "base/portable_math.hpp"

#include <cmath>
#include <numbers>

namespace hackle::portable {
namespace {

// ln 2 in two parts; the product of the first part with any exponent is exact.
constexpr double ln2_high = 0x1.62e42fefa3800p-1;
constexpr double ln2_low = 0x1.ef35793c76730p-45;

// Computes 2 artanh(s) for |s| < 0.18: the first omitted term of the series is below 1e-19 of the
// first.
double twice_artanh(double s) {
  const double s2 = s * s;
  double sum = 0.0;
  for (int n = 25; n >= 3; n -= 2) sum = s2 * (sum + 1.0 / n);
  return 2.0 * (s + s * sum);
}

}  // namespace

double log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < std::numbers::sqrt2 / 2.0) {
    mantissa *= 2.0;
    --exponent;
  }
  const double small = twice_artanh((mantissa - 1.0) / (mantissa + 1.0));
  return exponent * ln2_high + (small + exponent * ln2_low);
}

double log1p(double x) {
  return std::abs(x) < 0.3 ? twice_artanh(x / (2.0 + x)) : log(1.0 + x);
}

double exp(double x) {
  const double power = std::floor(x / std::numbers::ln2 + 0.5);
  const double rest = (x - power * ln2_high) - power * ln2_low;
  double sum = 1.0;
  for (int n = 16; n >= 1; --n) sum = 1.0 + sum * rest / n;
  return std::ldexp(sum, static_cast<int>(power));
}

// Uses Stirling's series, shifted by 15.
double gamma(double x) {
  double product = 1.0;
  for (int n = 0; n < 15; ++n) product *= x + n;
  const double z = x + 15.0, r = 1.0 / (z * z);
  const double series =
      (1.0 / 12 - r * (1.0 / 360 - r * (1.0 / 1260 - r * (1.0 / 1680 - r / 1188)))) / z;
  const double half_log_2pi = 0.91893853320467274178;
  return exp((z - 0.5) * log(z) - z + half_log_2pi + series) / product;
}

// Uses a series of erf whose terms all have one sign near 0, and the continued fraction of erfc
// elsewhere.
double normal_below(double x) {
  const double z = std::abs(x) / std::numbers::sqrt2;
  const double bell = exp(-std::fmin(z * z, 690.0)) * std::numbers::inv_sqrtpi;
  double tail = 0.0;
  if (z < 2.0) {
    double sum = 0.0;
    for (int n = 40; n >= 1; --n) sum = (1.0 + sum) * (2.0 * z * z) / (2 * n + 1);
    tail = 0.5 - bell * z * (1.0 + sum);
  } else {
    double fraction = 0.0;
    for (int n = 100; n >= 1; --n) fraction = 0.5 * n / (z + fraction);
    tail = 0.5 * bell / (z + fraction);
  }
  return x < 0.0 ? tail : 1.0 - tail;
}

}  // namespace hackle::portable
