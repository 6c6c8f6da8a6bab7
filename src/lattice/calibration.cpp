// SPDX-License-Identifier: MIT
#include "lattice/calibration.hpp"

#include <cmath>
#include <numbers>

namespace hackle {

using std::numbers::pi;

Moduli moduli(const Family& family, double c, double dx, Plane plane) {
  // The stretch of a bond is xi.(strain offset)/|xi|^2; offset and xi differ only with centroids.
  double xx = 0.0, xy = 0.0, shear = 0.0;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    const double r3 = std::pow(xi.squaredNorm(), 1.5);
    xx += weight * (xi.x() * a) * (xi.x() * a) / r3;
    xy += weight * (xi.x() * a) * (xi.y() * b) / r3;
    shear += weight * 0.25 * (xi.x() * b + xi.y() * a) * (xi.x() * b + xi.y() * a) / r3;
  });
  // Half, times two for the opposite bonds; V = dx^2, and x^4/r^3 contributes one dx.
  const double scale = c * dx * dx * dx;
  Moduli moduli;
  moduli.C11 = scale * xx;
  moduli.C12 = scale * xy;
  if (plane == Plane::stress) {
    moduli.E = moduli.C11 - moduli.C12 * moduli.C12 / moduli.C11;
    moduli.nu = moduli.C12 / moduli.C11;
  } else {
    moduli.nu = moduli.C12 / (moduli.C11 + moduli.C12);
    moduli.E = (moduli.C11 - moduli.C12) * (1.0 + moduli.nu);
  }
  moduli.zener = 2.0 * (scale * shear) / (moduli.C11 - moduli.C12);
  return moduli;
}

double fracture_energy(const Family& family, double c, double s0, double dx, const Vec2& normal) {
  double sum = 0.0;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    sum += weight * xi.norm() * std::abs(Vec2(a, b).dot(normal));
  });
  return 0.5 * c * s0 * s0 * (dx * dx) * (dx * dx) * sum;
}

namespace {

// The factors of E/(pi delta^3) in c, and of G0/(E delta) in s0^2 (src/lattice/README.md 3.3).
struct ContinuumFactors {
  double c, s0_squared;
};

ContinuumFactors continuum_factors(Micromodulus micromodulus, Plane plane) {
  const bool stress = plane == Plane::stress;
  if (micromodulus == Micromodulus::constant)
    return stress ? ContinuumFactors{9.0, 4.0 * pi / 9.0}
                  : ContinuumFactors{48.0 / 5.0, 5.0 * pi / 12.0};
  return stress ? ContinuumFactors{36.0, 5.0 * pi / 9.0}
                : ContinuumFactors{192.0 / 5.0, 25.0 * pi / 48.0};
}

}  // namespace

Calibration calibrate(const Family& family, const Material& material, double dx,
                      Constants constants, Plane plane) {
  const double delta = family.m() * dx, volume = pi * (delta * delta * delta);
  const Vec2 across{0.0, 1.0};
  const ContinuumFactors factors = continuum_factors(family.micromodulus(), plane);
  Calibration result;
  switch (constants) {
    case Constants::lattice:
      result.c = material.E / moduli(family, 1.0, dx, plane).E;
      result.s0 = std::sqrt(material.G0 / fracture_energy(family, result.c, 1.0, dx, across));
      break;
    case Constants::continuum:
      result.c = factors.c * material.E / volume;
      result.s0 = std::sqrt(factors.s0_squared * material.G0 / (material.E * delta));
      break;
    case Constants::paper:
      result.c = 6.0 * material.E / (volume * (1.0 - material.nu));                // Eq. 8
      result.s0 = std::sqrt(4.0 * pi * material.G0 / (9.0 * material.E * delta));  // Eq. 10
      break;
  }
  if (material.s0 > 0.0) result.s0 = material.s0;
  if (material.c > 0.0) result.c = material.c;
  result.moduli = moduli(family, result.c, dx, plane);
  result.G0 = fracture_energy(family, result.c, result.s0, dx, across);
  return result;
}

}  // namespace hackle
