// SPDX-License-Identifier: MIT
// Compares energies with closed forms (src/lattice/README.md 3.1 and 3.4).
#include "measure/energy.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// The energy of a rectangle is bilinear in its sizes, so the mixed second difference is the energy
// of one inner cell, without the soft rim.
template <class Measure>
double inner_cell(Measure measure) {
  return measure(21, 18) - measure(20, 18) - measure(21, 17) + measure(20, 17);
}

double strain_energy(int nx, int ny, double exx, double eyy, double exy) {
  Simulation simulation(test::bare_plate(nx, ny), test::numerics(), {1});
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
    return Vec2(exx * x.x() + exy * x.y(), exy * x.x() + eyy * x.y());
  }));
  return energy(simulation).strain;
}

TEST(StrainEnergy, OfAUniformStrainGivesTheModuliOfTheLattice) {
  const Simulation probe(test::bare_plate(20, 20), test::numerics(), {1});
  const Moduli moduli = probe.lattice().calibration.moduli;
  const double V = std::pow(probe.lattice().grid.dx, 2);
  const double e = 1e-8;  // the nonlinear part is of this relative size, times a few
  const auto density = [&](double exx, double eyy, double exy) {
    return inner_cell([&](int nx, int ny) { return strain_energy(nx, ny, exx, eyy, exy); }) / V;
  };
  EXPECT_NEAR(density(e, 0, 0) / (0.5 * moduli.C11 * e * e), 1.0, 1e-6);
  EXPECT_NEAR(density(e, e, 0) / ((moduli.C11 + moduli.C12) * e * e), 1.0, 1e-6);
  EXPECT_NEAR(density(0, 0, e) / (2.0 * moduli.C12 * e * e), 1.0, 1e-6);
  // Uniaxial stress: the lateral strain is -nu e.
  EXPECT_NEAR(density(e, -moduli.nu * e, 0) / (0.5 * 65e9 * e * e), 1.0, 1e-6);
}

TEST(BrokenEnergy, OfAStraightCutIsG0TimesItsLength) {
  const auto broken = [](int nx) {
    Simulation simulation(test::bare_plate(nx, 20), test::numerics(), {1});
    State state = simulation.state();
    Plate cut = test::bare_plate(nx, 20);
    cut.cracks.push_back({{0.0, 0.005}, {cut.width, 0.005}, Born::broken});
    state.bonds = Lattice(cut, test::numerics()).bonds;
    simulation.restore(state);
    return energy(simulation).broken;
  };
  EXPECT_NEAR((broken(31) - broken(30)) / (204.0 * 0.5e-3), 1.0, 1e-9);
}

TEST(BrokenEnergy, OfACrackInTheSceneIsNotCounted) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics());
  EXPECT_EQ(energy(simulation).broken, 0.0);
  EXPECT_EQ(count_damage(simulation).broken_bonds, 0);
  EXPECT_GT(count_damage(simulation).max, 0.3);
}

TEST(KineticEnergy, OfARigidBodyIsHalfItsMassTimesItsSpeedSquared) {
  Simulation simulation(test::bare_plate(20, 10), test::numerics(), {1});
  const double speed = 3.0;  // m/s
  const double in_units = speed * simulation.dt() / simulation.lattice().grid.dx;
  simulation.restore(test::thrown(simulation, [&](const Vec2&) { return Vec2(in_units, 0); }));
  const double mass = 2235.0 * 10e-3 * 5e-3;  // kg per metre of thickness
  EXPECT_NEAR(energy(simulation).kinetic / (0.5 * mass * speed * speed), 1.0, 1e-12);
}

TEST(Ledger, ClosesWithoutBreakingAsTheStepShrinks) {
  const auto residual = [](double dt) {
    Plate plate = test::edge_crack(2e6);
    Numerics numerics = test::numerics();
    numerics.step = dt;
    Simulation simulation(plate, numerics);
    simulation.run(10e-6);
    EXPECT_EQ(count_damage(simulation).broken_bonds, 0);
    const Energy now = energy(simulation);
    return std::abs(now.residual() / now.external);
  };
  EXPECT_LT(residual(50e-9), 1e-3);  // src/solver/README.md 3.4
}

}  // namespace
}  // namespace hackle
