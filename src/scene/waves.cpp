// SPDX-License-Identifier: MIT
#include "scene/waves.hpp"

#include <cmath>

namespace hackle {
namespace {

// The Rayleigh function in x = (v/c_S)^2, divided by its trivial root x = 0; q = (c_S/c_L)^2.
double rayleigh_function(double x, double q) {
  const double left = (2.0 - x) * (2.0 - x);
  return (left - 4.0 * std::sqrt((1.0 - x) * (1.0 - q * x))) / x;
}

double rayleigh_ratio(double q) {
  double low = 1e-6, high = 1.0;  // negative at 0+, 1 at x = 1: exactly one root between
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (rayleigh_function(middle, q) < 0.0 ? low : high) = middle;
  }
  return std::sqrt(0.5 * (low + high));
}

}  // namespace

WaveSpeeds wave_speeds(double E, double nu, double rho, Plane plane) {
  WaveSpeeds speeds;
  const double stiffness = plane == Plane::stress
                               ? E / (1.0 - nu * nu)
                               : E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  speeds.longitudinal = std::sqrt(stiffness / rho);
  speeds.shear = std::sqrt(E / (2.0 * rho * (1.0 + nu)));
  const double ratio = speeds.shear / speeds.longitudinal;
  speeds.rayleigh = speeds.shear * rayleigh_ratio(ratio * ratio);
  return speeds;
}

}  // namespace hackle
