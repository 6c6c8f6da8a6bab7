// SPDX-License-Identifier: MIT
#include "lattice/symbol.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "lattice/calibration.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double dx = 0.5e-3;

// Phase speed over the exact speed of long waves in the continuum with c = 9E/(pi d^3), nu = 1/3.
Branches phase_speeds(double wavelength_in_dx) {
  const Family family(4.0, Quadrature::full);
  const Material material = test::duran50();
  const Calibration calibration = calibrate(family, material, dx, Constants::continuum);
  const double k = 2.0 * std::numbers::pi / wavelength_in_dx;
  const Branches rho_omega2 = symbol(family, calibration.c, dx, {k, 0.0});
  const double shear = std::sqrt(material.E * 3.0 / 8.0),
               longitudinal = std::sqrt(material.E * 9.0 / 8.0);
  return {std::sqrt(rho_omega2.min) / (k / dx) / shear,
          std::sqrt(rho_omega2.max) / (k / dx) / longitudinal};
}

TEST(Symbol, DispersesAsTheTableSays) {
  // src/lattice/README.md 4.2: wavelength in dx, longitudinal, transverse.
  const double table[][3] = {{100, 0.986, 0.962},
                             {20, 0.955, 0.945},
                             {12, 0.900, 0.914},
                             {8, 0.804, 0.857},
                             {4, 0.465, 0.627}};
  for (const auto& [wavelength, longitudinal, transverse] : table) {
    const Branches speeds = phase_speeds(wavelength);
    EXPECT_NEAR(speeds.max, longitudinal, 0.51e-3) << wavelength;
    EXPECT_NEAR(speeds.min, transverse, 0.51e-3) << wavelength;
  }
}

TEST(Symbol, LongWavesTravelWithTheModuliOfTheLattice) {
  const Family family(4.0, Quadrature::full);
  const double c = 1.0, k = 1e-3;
  const Moduli m = moduli(family, c, dx);
  const Branches rho_omega2 = symbol(family, c, dx, {k, 0.0});
  const double k2 = std::pow(k / dx, 2);
  // The next term is of the order (k m)^2/12.
  EXPECT_NEAR(rho_omega2.max / (m.C11 * k2), 1.0, 2e-6);
  EXPECT_NEAR(rho_omega2.min / (m.C12 * k2), 1.0, 2e-6);
}

TEST(StepLimit, IsThePublishedOne) {
  // src/lattice/README.md 4.3: Duran, dx 0.5 mm, m = 4, continuum constants: 234 ns.
  const Family family(4.0, Quadrature::full);
  const Calibration calibration = calibrate(family, test::duran50(), dx, Constants::continuum);
  EXPECT_NEAR(step_limit(family, calibration.c, 2235.0, dx), 234.0e-9, 0.5e-9);
}

// src/lattice/README.md 4.7: for large beta it falls as 2/(beta omega^2), by no more than rounding.
TEST(StepLimit, OfStrongDampingIsNeverNothing) {
  const Family family(4.0, Quadrature::full);
  const Calibration calibration = calibrate(family, test::duran50(), dx, Constants::continuum);
  const double plain = step_limit(family, calibration.c, 2235.0, dx), omega = 2.0 / plain;
  for (const double beta : {1.0, 1e9, 1e100}) {
    Touching touching;
    touching.stiffness_damping = beta;
    const double limit = step_limit(family, calibration.c, 2235.0, dx, touching);
    EXPECT_NEAR(limit * beta * omega * omega / 2.0, 1.0, 1e-9) << beta;
  }
}

TEST(StepLimit, MatchesThePeersTableInDimensionlessForm) {
  // src/lattice/README.md 4.3: the limit in dx sqrt(rho/E), continuum constants, full quadrature;
  // here from coarser samples of the symbol, which miss its peak by up to 0.2 %: they may lie above
  // the limit, not below.
  const double table[][2] = {{2, 1.260}, {3, 1.865}, {4, 2.526}, {5, 3.093}, {6, 3.751}};
  Material unit{"unit", 1.0, 1.0, 0.2, 1.0};
  for (const auto& [m, limit] : table) {
    const Family family(m, Quadrature::full);
    const Calibration calibration = calibrate(family, unit, 1.0, Constants::continuum);
    const double exact = step_limit(family, calibration.c, 1.0, 1.0);
    EXPECT_LT(exact, limit + 0.51e-3) << m;
    EXPECT_GT(exact, limit * 0.998) << m;
  }
}

// Returns the largest squared frequency of n by n nodes, with a horizon of 2.6 spacings and c = dx
// = 1. Bonds keep a random share of their stiffness and nodes have random masses of 1 to 2, unless
// `whole`.
double largest_square(const Family& family, int n, bool whole, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n * n, 2 * n * n);
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(2 * n * n);
  for (int node = 0; node < n * n && !whole; ++node)
    mass[2 * node] = mass[2 * node + 1] = 1.0 + share(random);
  const auto add_bond = [&](int i, int j, int a, int b, const Eigen::Matrix2d& k) {
    const int one = 2 * (j * n + i), other = 2 * ((j + b) * n + i + a);
    stiffness.block<2, 2>(one, one) += k;
    stiffness.block<2, 2>(other, other) += k;
    stiffness.block<2, 2>(one, other) -= k;
    stiffness.block<2, 2>(other, one) -= k;
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
        if (i + a < 0 || i + a >= n || j + b >= n) return;
        const double factor = (whole ? 1.0 : share(random)) * weight / std::pow(xi.norm(), 3);
        add_bond(i, j, a, b, factor * (xi * xi.transpose()));
      });
  const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
             root.asDiagonal() * stiffness * root.asDiagonal(), Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

// The stiffness of a plate is a sum of positive semidefinite bonds, none larger than the lattice's,
// for any direction of a bond: no frequency exceeds the limit.
TEST(LargestFrequency, BoundsEveryPlateOfWeakerBondsAndHeavierNodes) {
  std::mt19937 random(3);
  for (const auto quadrature :
       {Quadrature::full, Quadrature::ramp, Quadrature::area, Quadrature::centroid})
    for (const auto micromodulus : {Micromodulus::constant, Micromodulus::conical}) {
      const Family family(2.6, quadrature, micromodulus);
      const double limit = std::pow(largest_frequency(family, 1.0, 1.0, 1.0), 2);
      const double whole = largest_square(family, 7, true, random);
      EXPECT_LE(whole, limit * (1.0 + 1e-9));
      EXPECT_GT(whole, 0.8 * limit);  // the bound is not loose
      for (int trial = 0; trial < 2; ++trial)
        EXPECT_LE(largest_square(family, 7, false, random), limit * (1.0 + 1e-9));
    }
}

TEST(LargestFrequency, IsAboveEverySampleAndReached) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (const double m : {2.0, 3.0, 4.0, 6.5})
    for (const auto quadrature : {Quadrature::full, Quadrature::area, Quadrature::centroid})
      for (const auto micromodulus : {Micromodulus::constant, Micromodulus::conical}) {
        const Family family(m, quadrature, micromodulus);
        const double max = std::pow(largest_frequency(family, 1.0, 1.0, 1.0), 2);
        double seen = 0.0;
        for (int n = 0; n < 5000; ++n) {
          const Branches sample = symbol(family, 1.0, 1.0, {angle(random), angle(random)});
          seen = std::max(seen, sample.max);
        }
        EXPECT_LE(seen, max * (1.0 + 1e-9)) << m;
        EXPECT_GT(seen, max * 0.99) << m;
      }
}

// A long horizon makes the symbol nearly round: its peak is one of many on a ring, and the highest
// sample need not belong to the highest peak.
TEST(LargestFrequency, IsThatOfTheHighestOfManySummits) {
  const std::pair<double, Quadrature> many[] = {{4.4, Quadrature::ramp},
                                                {7.3, Quadrature::full},
                                                {8.0, Quadrature::centroid},
                                                {10.0, Quadrature::area}};
  for (const auto& [m, quadrature] : many) {
    const Family family(m, quadrature);
    const double max = std::pow(largest_frequency(family, 1.0, 1.0, 1.0), 2);
    double seen = 0.0;
    constexpr int n = 160;  // of an octant, up to k = 1.6, beyond the ring
    for (int j = 0; j <= n; ++j)
      for (int i = j; i <= n; ++i)
        seen = std::max(seen, symbol(family, 1.0, 1.0, Vec2(i, j) * (1.6 / n)).max);
    EXPECT_LE(seen, max * (1.0 + 1e-9)) << m;
    EXPECT_GT(seen, max * (1.0 - 3e-3)) << m;
  }
}

}  // namespace
}  // namespace hackle
