// SPDX-License-Identifier: MIT
#include "lattice/calibration.hpp"

#include <cmath>
#include <numbers>

namespace hackle {

using std::numbers::pi;

Moduli moduli(const Family& family, double c, double dx) {
  double xx = 0.0, xy = 0.0;
  family.for_each_bond([&](int, int, const Vec2& xi, double weight, int) {
    const Vec2 squares = xi.cwiseAbs2();
    const double r2 = xi.squaredNorm(), r3 = r2 * std::sqrt(r2);
    xx += weight * squares.x() * squares.x() / r3;
    xy += weight * squares.x() * squares.y() / r3;
  });
  // Half, times two for the opposite bonds; V = dx^2, and x^4/r^3 carries one dx.
  const double scale = c * dx * dx * dx;
  Moduli moduli;
  moduli.C11 = scale * xx;
  moduli.C12 = scale * xy;
  moduli.E = moduli.C11 - moduli.C12 * moduli.C12 / moduli.C11;
  moduli.nu = moduli.C12 / moduli.C11;
  moduli.zener = 2.0 * moduli.C12 / (moduli.C11 - moduli.C12);
  return moduli;
}

double fracture_energy(const Family& family, double c, double s0, double dx, const Vec2& normal) {
  double sum = 0.0;
  family.for_each_bond([&](int, int, const Vec2& xi, double weight, int) {
    sum += weight * xi.norm() * std::abs(xi.dot(normal));
  });
  return 0.5 * c * s0 * s0 * (dx * dx) * (dx * dx) * sum;
}

Calibration calibrate(const Family& family, const Material& material, double dx,
                      Constants constants) {
  const double delta = family.m() * dx;
  const Vec2 across{0.0, 1.0};
  Calibration result;
  switch (constants) {
    case Constants::lattice:
      result.c = material.E / moduli(family, 1.0, dx).E;
      result.s0 = std::sqrt(material.G0 / fracture_energy(family, result.c, 1.0, dx, across));
      break;
    case Constants::continuum:
      result.c = 9.0 * material.E / (pi * (delta * delta * delta));
      result.s0 = std::sqrt(4.0 * pi * material.G0 / (9.0 * material.E * delta));
      break;
    case Constants::paper:
      result.c = 6.0 * material.E / (pi * (delta * delta * delta) * (1.0 - material.nu));  // Eq. 8
      result.s0 = std::sqrt(4.0 * pi * material.G0 / (9.0 * material.E * delta));          // Eq. 10
      break;
  }
  result.moduli = moduli(family, result.c, dx);
  result.G0 = fracture_energy(family, result.c, result.s0, dx, across);
  return result;
}

}  // namespace hackle
