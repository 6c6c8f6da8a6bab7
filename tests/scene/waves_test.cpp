// SPDX-License-Identifier: MIT
#include "scene/waves.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hackle {
namespace {

// src/lattice/README.md 4.6, printed to 1 m/s.
struct Row {
  double E, nu, rho, longitudinal, shear, rayleigh;
};

class Waves : public testing::TestWithParam<Row> {};

TEST_P(Waves, MatchTheTable) {
  const Row row = GetParam();
  const WaveSpeeds speeds = wave_speeds(row.E, row.nu, row.rho);
  EXPECT_NEAR(speeds.longitudinal, row.longitudinal, 0.51);
  EXPECT_NEAR(speeds.shear, row.shear, 0.51);
  EXPECT_NEAR(speeds.rayleigh, row.rayleigh, 0.51);
}

INSTANTIATE_TEST_SUITE_P(Table, Waves,
                         testing::Values(Row{65e9, 1.0 / 3.0, 2235, 5720, 3302, 3036},
                                         Row{65e9, 0.2, 2235, 5504, 3481, 3151},
                                         Row{72e9, 1.0 / 3.0, 2440, 5762, 3326, 3058},
                                         Row{72e9, 0.22, 2440, 5569, 3478, 3156},
                                         Row{32e9, 0.2, 2450, 3689, 2333, 2112}));

TEST(WaveSpeeds, InPlaneStrainMatchTheTable) {
  const WaveSpeeds speeds = wave_speeds(32e9, 0.2, 2450.0, Plane::strain);
  EXPECT_NEAR(speeds.longitudinal, 3810.0, 0.51);
  EXPECT_NEAR(speeds.shear, 2333.0, 0.51);
  EXPECT_NEAR(speeds.rayleigh, 2125.0, 0.51);
}

// E and nu of plane strain equal those of plane stress with the same moduli C11, C12 and C66.
TEST(WaveSpeeds, AreThoseOfTheModuliInBothPlanes) {
  const double E = 5.0 / 6.0, nu = 0.25;  // C11 = 1, C12 = C66 = 1/3
  const WaveSpeeds thick = wave_speeds(E, nu, 1.0, Plane::strain);
  const WaveSpeeds thin = wave_speeds(8.0 / 9.0, 1.0 / 3.0, 1.0, Plane::stress);
  EXPECT_NEAR(thick.longitudinal, 1.0, 1e-15);
  EXPECT_NEAR(thick.shear, std::sqrt(1.0 / 3.0), 1e-15);
  EXPECT_NEAR(thick.longitudinal, thin.longitudinal, 1e-15);
  EXPECT_NEAR(thick.rayleigh, thin.rayleigh, 1e-15);
}

TEST(WaveSpeeds, RayleighSolvesItsEquation) {
  for (const auto plane : {Plane::stress, Plane::strain})
    for (double nu = -0.9; nu < 0.5; nu += 0.1) {
      const WaveSpeeds speeds = wave_speeds(1.0, nu, 1.0, plane);
      const double s = std::pow(speeds.rayleigh / speeds.shear, 2);
      const double l = std::pow(speeds.rayleigh / speeds.longitudinal, 2);
      // Both sides are of order 1; bisection leaves a few rounding errors.
      EXPECT_NEAR(std::pow(2.0 - s, 2), 4.0 * std::sqrt((1.0 - s) * (1.0 - l)), 1e-12) << nu;
      EXPECT_LT(speeds.rayleigh, speeds.shear);
    }
}

}  // namespace
}  // namespace hackle
