// SPDX-License-Identifier: MIT
// Compares the stiffness with the moduli of the lattice, and the speed of waves with closed forms.
#include "lattice/elastic_response.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene/waves.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

double stiffness_times_nodes(int nx, int ny, const Numerics& numerics) {
  const Lattice lattice(test::bare_plate(nx, ny), numerics);
  return elastic_response(lattice, 1e-9).stiffness * nx * ny;
}

// Bilinear in both sizes: the mixed second difference is one inner cell, without the rim.
double stiffness_inside(const Numerics& numerics) {
  const auto at = [&](int nx, int ny) { return stiffness_times_nodes(nx, ny, numerics); };
  return at(21, 18) - at(20, 18) - at(21, 17) + at(20, 17);
}

TEST(ElasticResponse, IsC11AwayFromRims) {
  for (const Quadrature quadrature :
       {Quadrature::full, Quadrature::ramp, Quadrature::area, Quadrature::centroid}) {
    Numerics numerics = test::numerics();
    numerics.quadrature = quadrature;
    const Lattice lattice(test::bare_plate(20, 20), numerics);
    EXPECT_NEAR(stiffness_inside(numerics) / lattice.calibration.moduli.C11, 1.0, 1e-9)
        << name_of(quadrature);
  }
}

// The bonds that cross a rim are half lost to the plate. Their sum over the sum of all bonds is a
// depth: int r^3 dr int (cos^4 + sin^4) cos over half a circle, over int r^2 dr int (cos^4 +
// sin^4).
TEST(ElasticResponse, LosesToRimsInProportionToTheHorizon) {
  const auto lost = [](double horizon) {
    const Lattice lattice(test::bare_plate(160, 160), test::numerics(0.5e-3, horizon));
    return 1.0 - elastic_response(lattice, 1e-9).stiffness / lattice.calibration.moduli.C11;
  };
  const double whole = 3.0 * std::numbers::pi / 2.0, half = 16.0 / 15.0 + 2.0 / 5.0;
  const double depth = (half / 4.0) / (whole / 3.0);  // in horizons, per rim
  const double side = 0.08;
  EXPECT_NEAR(lost(4e-3), 4.0 * depth * 4e-3 / side, 0.05 * 4.0 * depth * 4e-3 / side)
      << "corners are counted twice";
  EXPECT_NEAR(lost(4e-3) / lost(2e-3), 2.0, 0.15);
}

TEST(ElasticResponse, IsHigherWithCorrectedSurfaces) {
  Numerics corrected = test::numerics();
  corrected.surface = Surface::energy;
  EXPECT_GT(stiffness_times_nodes(20, 20, corrected),
            stiffness_times_nodes(20, 20, test::numerics()));
}

TEST(ElasticResponse, HasWavesOfTheMaterialOnAFineLattice) {
  const double horizon = 2e-3;
  const Lattice lattice(test::bare_plate(1000, 1000), test::numerics(0.5e-3, horizon));
  const ElasticResponse response = elastic_response(lattice, 1e-9);
  EXPECT_NEAR(response.wavelength, 0.1, 1e-12);
  const double exact = std::sqrt(lattice.calibration.moduli.C11 / lattice.rho);
  EXPECT_NEAR(response.wave_speed / exact, 1.0, 1e-3);
  EXPECT_LT(response.wave_speed, exact);
  // nu of the lattice is near 1/3.
  EXPECT_NEAR(response.wave_speed / wave_speeds(65e9, 1.0 / 3.0, 2235.0).longitudinal, 1.0, 0.02);
}

// To the fourth order of k: omega^2 = c_L^2 k^2 (1 - k^2 M6/(12 M4)), M the moments of x.
TEST(ElasticResponse, ShortWavesAreSlowerAsTheMomentsOfTheFamilySay) {
  const Lattice lattice(test::bare_plate(400, 400), test::numerics());
  double fourth = 0.0, sixth = 0.0;
  lattice.family.for_each_bond([&](int column, int, const Vec2& xi, double weight, int) {
    const double of_bond = weight * std::pow(xi.x(), 2) / std::pow(xi.norm(), 3);
    fourth += of_bond * std::pow(column, 2);
    sixth += of_bond * std::pow(column, 4);
  });
  const ElasticResponse response = elastic_response(lattice, 1e-9);
  const double k = 2.0 * std::numbers::pi * lattice.grid.dx / response.wavelength;
  const double loss = k * k * sixth / fourth / 24.0;
  const double exact = std::sqrt(lattice.calibration.moduli.C11 / lattice.rho);
  EXPECT_NEAR(1.0 - response.wave_speed / exact, loss, 0.02 * loss);
}

// Leapfrog makes them faster: asin(h)/h = 1 + h^2/6 + 3 h^4/40 + .., h = omega dt/2.
TEST(ElasticResponse, LongStepsMakeWavesFaster) {
  const Lattice lattice(test::bare_plate(100, 100), test::numerics());
  const double dt = lattice.step_limit;
  const ElasticResponse exact = elastic_response(lattice, 1e-9 * dt);
  const double omega = exact.wave_speed * 2.0 * std::numbers::pi / exact.wavelength;
  const double h = 0.5 * omega * dt;
  const double gain = h * h / 6.0 + 3.0 * std::pow(h, 4) / 40.0;
  EXPECT_NEAR(elastic_response(lattice, dt).wave_speed / exact.wave_speed - 1.0, gain, 0.05 * gain);
}

}  // namespace
}  // namespace hackle
