// SPDX-License-Identifier: MIT
// Compares stress and energy of nodes with closed forms (src/lattice/README.md 3.1).
#include "measure/bond_field.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// Makes a plate under a uniform strain, small enough to be linear.
Simulation strained(double exx, double eyy, double exy) {
  Simulation simulation(test::bare_plate(24, 20), test::numerics(), {1});
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
    return Vec2(exx * x.x() + exy * x.y(), exy * x.x() + eyy * x.y());
  }));
  return simulation;
}

constexpr double strain = 1e-7;

TEST(Stress, OfAUniformStrainIsThatOfTheLatticeModuli) {
  struct Case {
    double exx, eyy, exy;
  };
  for (const Case& c :
       {Case{strain, 0, 0}, {0, strain, 0}, {0, 0, strain}, {2 * strain, -strain, 0.5 * strain}}) {
    const Simulation simulation = strained(c.exx, c.eyy, c.exy);
    const Lattice& lattice = simulation.lattice();
    const Moduli& moduli = lattice.calibration.moduli;
    const Stress inner = stresses(simulation)[lattice.grid.index(12, 10)];
    // The stretch is linear up to a relative error of the size of the strain.
    const double tolerance = 4.0 * strain * moduli.C11 * strain;
    EXPECT_NEAR(inner.xx, moduli.C11 * c.exx + moduli.C12 * c.eyy, tolerance);
    EXPECT_NEAR(inner.yy, moduli.C12 * c.exx + moduli.C11 * c.eyy, tolerance);
    EXPECT_NEAR(inner.xy, 2.0 * moduli.C12 * c.exy, tolerance);
  }
}

TEST(Stress, HasItsPrincipalValues) {
  const Stress stress{3.0, -1.0, 1.5};
  EXPECT_DOUBLE_EQ(stress.shear(), 2.5);
  EXPECT_DOUBLE_EQ(stress.first(), 3.5);
  EXPECT_DOUBLE_EQ(stress.second(), -1.5);
  EXPECT_DOUBLE_EQ(stress.von_mises(), std::sqrt(3.5 * 3.5 + 3.5 * 1.5 + 1.5 * 1.5));
}

TEST(Stress, OfAUniaxialStrainWithoutLateralStressIsE) {
  const Simulation probe = strained(0, 0, 0);
  const Moduli& moduli = probe.lattice().calibration.moduli;
  const Simulation simulation = strained(strain, -moduli.nu * strain, 0);
  const Stress inner = stresses(simulation)[probe.lattice().grid.index(12, 10)];
  EXPECT_NEAR(inner.xx, moduli.E * strain, 1e-5 * moduli.E * strain);
  EXPECT_NEAR(inner.yy, 0.0, 1e-5 * moduli.E * strain);
}

TEST(EnergyDensity, AddsUpToTheStrainEnergy) {
  const Simulation simulation = strained(2e-4, -1e-4, 5e-5);
  const double dx = simulation.lattice().grid.dx;
  double sum = 0.0;
  for (const double density : energy_densities(simulation)) sum += density * dx * dx;
  EXPECT_NEAR(sum, energy(simulation).strain, 1e-12 * sum);
}

TEST(ClosestToBreaking, IsOneWhereABondIsAboutToBreak) {
  const double s0 = strained(0, 0, 0).lattice().calibration.s0;
  const Simulation simulation = strained(0.8 * s0, 0, 0);
  const std::vector<double> shares = closest_to_breaking(simulation);
  EXPECT_NEAR(shares[simulation.lattice().grid.index(12, 10)], 0.8, 1e-9);
  const std::vector<double> pressed = closest_to_breaking(strained(-s0, -s0, 0));
  EXPECT_LT(*std::ranges::max_element(pressed), 0.0);
}

TEST(FragmentNumbers, CountFromTheLargest) {
  Plate plate = test::bare_plate(30, 20);
  const std::vector<int> whole = fragment_numbers(Simulation(plate, test::numerics()));
  EXPECT_EQ(*std::ranges::max_element(whole), 1);
  plate.cracks.push_back({{5e-3, 0.0}, {5e-3, plate.height}});
  const Simulation simulation(plate, test::numerics());
  const std::vector<int> numbers = fragment_numbers(simulation);
  const Grid& grid = simulation.lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      EXPECT_EQ(numbers[grid.index(i, j)], i < 10 ? 2 : 1) << i << ", " << j;
}

TEST(FragmentNumbers, ANodeWithoutBondsHasNone) {
  Simulation simulation(test::bare_plate(12, 12), test::numerics());
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(x); }));
  simulation.step();
  for (const int number : fragment_numbers(simulation)) EXPECT_EQ(number, 0);
}

}  // namespace
}  // namespace hackle
