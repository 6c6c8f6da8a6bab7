// SPDX-License-Identifier: MIT
#include "lattice/calibration.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double dx = 0.5e-3;

Vec2 direction(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {-std::sin(angle), std::cos(angle)};
}

// src/lattice/README.md 3.6: the results of c = 9E/(pi d^3) and s0 = sqrt(4 pi G0/(9 E d)). Four
// digits are printed, so the tolerance is half of the last.
struct Row {
  double m;
  Quadrature quadrature;
  double E, nu, zener, G_0, G_15, G_45;
};

class Table : public testing::TestWithParam<Row> {};

TEST_P(Table, OfModuliAndFractureEnergiesIsReproduced) {
  const Row row = GetParam();
  const Material material = test::duran50();
  const Family family(row.m, row.quadrature);
  const Calibration result = calibrate(family, material, dx, Constants::continuum);
  EXPECT_NEAR(result.moduli.E / material.E, row.E, 0.51e-4);
  EXPECT_NEAR(result.moduli.nu, row.nu, 0.51e-3);
  EXPECT_NEAR(result.moduli.zener, row.zener, 1e-3);  // derived from rounded moduli there
  const auto G = [&](double degrees) {
    return fracture_energy(family, result.c, result.s0, dx, direction(degrees)) / material.G0;
  };
  EXPECT_NEAR(G(0.0), row.G_0, 0.51e-3);
  EXPECT_NEAR(G(15.0), row.G_15, 0.51e-3);
  EXPECT_NEAR(G(45.0), row.G_45, 0.51e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Continuum, Table,
    testing::Values(Row{3, Quadrature::full, 1.0644, 0.318, 0.934, 1.026, 1.081, 1.048},
                    Row{3.015, Quadrature::full, 1.0486, 0.318, 0.934, 1.006, 1.059, 1.027},
                    Row{4, Quadrature::full, 0.9860, 0.317, 0.928, 0.929, 0.958, 0.957},
                    Row{4, Quadrature::ramp, 0.8747, 0.337, 1.018, 0.837, 0.853, 0.843},
                    Row{5, Quadrature::full, 1.0038, 0.362, 1.137, 1.070, 1.081, 1.055},
                    Row{6, Quadrature::full, 0.9820, 0.345, 1.052, 0.996, 1.004, 0.993},
                    Row{4, Quadrature::area, 1.0144, 0.329, 0.981, 1.015, 1.026, 1.023},
                    Row{6, Quadrature::area, 1.0057, 0.332, 0.994, 1.006, 1.012, 1.009},
                    Row{8, Quadrature::area, 1.0030, 0.333, 0.997, 1.003, 1.006, 1.005}));

TEST(Calibration, LatticeConstantsGiveTheMaterialExactly) {
  const Material material = test::duran50();
  for (const double m : {2.0, 2.4, 3.0, 3.015, 4.0, 5.5, 6.0, 8.0, 11.3, 16.0})
    for (const auto quadrature :
         {Quadrature::full, Quadrature::ramp, Quadrature::area, Quadrature::centroid})
      for (const auto micromodulus : {Micromodulus::constant, Micromodulus::conical})
        for (const auto plane : {Plane::stress, Plane::strain}) {
          const Family family(m, quadrature, micromodulus);
          const Calibration result = calibrate(family, material, dx, Constants::lattice, plane);
          EXPECT_NEAR(result.moduli.E / material.E, 1.0, 1e-12);
          EXPECT_NEAR(result.G0 / material.G0, 1.0, 1e-12);
        }
}

// src/lattice/README.md 3.3: on a lattice that is fine relative to the horizon the continuum
// constants give the material, with the Poisson's ratio of the theory. With exact areas the error
// falls like 1/m^2.
TEST(Calibration, ContinuumConstantsConvergeToTheMaterial) {
  const Material material = test::duran50();
  for (const auto quadrature : {Quadrature::area, Quadrature::centroid})
    for (const auto micromodulus : {Micromodulus::constant, Micromodulus::conical})
      for (const auto plane : {Plane::stress, Plane::strain}) {
        double before = 1.0;
        for (const double m : {4.0, 6.0, 8.0, 15.0}) {
          const Family family(m, quadrature, micromodulus);
          const Calibration result = calibrate(family, material, dx, Constants::continuum, plane);
          const double E = std::abs(result.moduli.E / material.E - 1.0);
          const double G = std::abs(result.G0 / material.G0 - 1.0);
          EXPECT_LT(std::max(E, G), 0.75 * before) << m;
          EXPECT_LT(std::max(E, G), 0.85 / (m * m)) << m;
          EXPECT_NEAR(result.moduli.nu, plane == Plane::stress ? 1.0 / 3.0 : 0.25, 0.15 / m);
          before = std::max(E, G);
        }
      }
}

// src/lattice/README.md 3.3, in units of E/(pi delta^3) and G0/(E delta).
TEST(Calibration, ContinuumConstantsOfEveryMicromodulusAndPlane) {
  constexpr double pi = std::numbers::pi;
  const Material unit{"unit", 1.0, 1.0, 0.25, 1.0};
  const double delta = 4.0 * dx;
  const auto expect = [&](Micromodulus micromodulus, Plane plane, double c, double s0_squared) {
    const Family family(4.0, Quadrature::area, micromodulus);
    const Calibration result = calibrate(family, unit, dx, Constants::continuum, plane);
    EXPECT_NEAR(result.c * pi * std::pow(delta, 3), c, 1e-12 * c);
    EXPECT_NEAR(result.s0 * result.s0 * delta, s0_squared, 1e-12);
  };
  expect(Micromodulus::constant, Plane::stress, 9.0, 4.0 * pi / 9.0);
  expect(Micromodulus::constant, Plane::strain, 48.0 / 5.0, 5.0 * pi / 12.0);
  expect(Micromodulus::conical, Plane::stress, 36.0, 5.0 * pi / 9.0);
  expect(Micromodulus::conical, Plane::strain, 192.0 / 5.0, 25.0 * pi / 48.0);
}

// In every bond-based model C12 = C66: nu = 1/3 in plane stress is nu = 1/4 in plane strain.
TEST(Calibration, TheTwoPlanesSeeTheSameLattice) {
  const Family family(4.0, Quadrature::full);
  const Moduli thin = moduli(family, 1.0, dx, Plane::stress);
  const Moduli thick = moduli(family, 1.0, dx, Plane::strain);
  EXPECT_EQ(thin.C11, thick.C11);
  EXPECT_NEAR(thick.nu, thin.nu / (1.0 + thin.nu), 1e-15);
  EXPECT_NEAR(thick.E / (2.0 * (1.0 + thick.nu)), thin.E / (2.0 * (1.0 + thin.nu)),
              1e-12 * thin.E);  // the shear modulus
}

TEST(Calibration, ContinuumConstantsAreTheTextbooks) {
  // src/lattice/README.md 3.3: Duran at a horizon of 2 mm.
  const Calibration result =
      calibrate(Family(4.0, Quadrature::full), test::duran50(), dx, Constants::continuum);
  EXPECT_NEAR(result.c, 2.32764e19, 0.5e14);
  EXPECT_NEAR(result.s0, 1.4802e-3, 0.5e-7);
}

TEST(Calibration, ThePapersConstantsScaleBothEAndG0) {
  // Eq. 8 with Eq. 10 is (2/3)/(1 - nu) of the continuum pair, 0.8333 for nu = 0.2
  // (src/lattice/README.md 3.7).
  const Family family(4.0, Quadrature::full);
  const Calibration paper = calibrate(family, test::duran50(), dx, Constants::paper);
  const Calibration continuum = calibrate(family, test::duran50(), dx, Constants::continuum);
  EXPECT_NEAR(paper.moduli.E / continuum.moduli.E, 0.8 + 1.0 / 30.0, 1e-12);
  EXPECT_NEAR(paper.G0 / continuum.G0, 0.8 + 1.0 / 30.0, 1e-12);
}

TEST(Calibration, DoesNotDependOnTheUnitOfLength) {
  // On a given family s0 scales as spacing^-1/2, E not at all.
  const Family family(4.0, Quadrature::full);
  const Calibration fine = calibrate(family, test::duran50(), dx / 4.0, Constants::lattice);
  const Calibration coarse = calibrate(family, test::duran50(), dx, Constants::lattice);
  EXPECT_NEAR(fine.s0 / coarse.s0, 2.0, 1e-13);
  EXPECT_NEAR(fine.moduli.E / coarse.moduli.E, 1.0, 1e-13);
}

TEST(Calibration, AGivenMicromodulusHoldsAndTheModulusFollowsFromIt) {
  const Family family(3, Quadrature::full);
  Material material = test::duran50();
  const Calibration own = calibrate(family, material, dx, Constants::lattice);
  for (const Constants constants : {Constants::lattice, Constants::continuum, Constants::paper}) {
    material.c = 2.0 * own.c;
    const Calibration given = calibrate(family, material, dx, constants);
    EXPECT_EQ(given.c, 2.0 * own.c);
    EXPECT_DOUBLE_EQ(given.moduli.E, 2.0 * material.E);
    EXPECT_DOUBLE_EQ(given.G0, fracture_energy(family, given.c, given.s0, dx, {0.0, 1.0}));
  }
}

// Round trip: giving the critical stretch that follows from G0 must result in that G0.
TEST(Calibration, AGivenCriticalStretchHoldsAndG0FollowsFromIt) {
  const Family family(4, Quadrature::area);
  Material material = test::duran50();
  for (const Constants constants : {Constants::lattice, Constants::continuum, Constants::paper}) {
    const Calibration from_G0 = calibrate(family, test::duran50(), dx, constants);
    material.G0 = 0.0;
    material.s0 = from_G0.s0;
    const Calibration from_s0 = calibrate(family, material, dx, constants);
    EXPECT_EQ(from_s0.s0, from_G0.s0);
    EXPECT_EQ(from_s0.G0, from_G0.G0);
    material.s0 *= 2.0;
    EXPECT_DOUBLE_EQ(calibrate(family, material, dx, constants).G0, 4.0 * from_G0.G0);
  }
}

}  // namespace
}  // namespace hackle
