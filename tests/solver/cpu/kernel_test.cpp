// SPDX-License-Identifier: MIT
// What a force kernel must do for given displacements (src/solver/README.md 2.4 and 3.3).
#include "solver/cpu/kernel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lattice/symbol.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// The largest component of the acceleration of nodes farther than the horizon from the rim.
double inner_acceleration(const Simulation& simulation) {
  const Grid& grid = simulation.lattice().grid;
  const int reach = simulation.lattice().family.reach();
  const std::vector<Vec2> all = test::accelerations(simulation);
  double max = 0.0;
  for (int j = reach; j < grid.ny - reach; ++j)
    for (int i = reach; i < grid.nx - reach; ++i)
      max = std::max(max, all[grid.index(i, j)].cwiseAbs().maxCoeff());
  return max;
}

class EveryKernel : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (!is_supported(GetParam()))
      GTEST_SKIP() << "this machine has no "
                   << instruction_set_names[static_cast<std::size_t>(GetParam())];
  }
  Simulation bare(int nx, int ny, double m = 4.0) const {
    return Simulation(test::bare_plate(nx, ny), test::numerics(0.5e-3, m * 0.5e-3),
                      {1, GetParam()});
  }
};

TEST_P(EveryKernel, RigidTranslationMakesNoForceAtAll) {
  Simulation simulation = bare(23, 19);
  simulation.restore(test::displaced(simulation, [](const Vec2&) { return Vec2(0.3, -7.1); }));
  EXPECT_EQ(test::largest(test::accelerations(simulation)), 0.0);
}

TEST_P(EveryKernel, RigidRotationStretchesNothing) {
  Simulation simulation = bare(23, 19);
  const double angle = 0.7;
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
    return Vec2(std::cos(angle) * x.x() - std::sin(angle) * x.y() - x.x(),
                std::sin(angle) * x.x() + std::cos(angle) * x.y() - x.y());
  }));
  // Rounding of u, about 12 eps, relative to a stretch of 1 that would give accelerations of
  // order 1.
  EXPECT_LT(inner_acceleration(simulation), 1e-13);
  simulation.step();
  EXPECT_EQ(simulation.state().bonds, simulation.lattice().bonds);
}

TEST_P(EveryKernel, UniformStrainLeavesInnerNodesInBalance) {
  for (const double m : {2.0, 3.0, 4.0, 6.0, 9.0}) {
    Simulation simulation = bare(31, 29, m);
    simulation.restore(test::displaced(simulation, [](const Vec2& x) {
      return Vec2(4e-4 * x.x() + 2e-4 * x.y(), -3e-4 * x.x() + 1e-4 * x.y());
    }));
    EXPECT_LT(inner_acceleration(simulation), 1e-15) << m;  // forces are of order 1e-3
    simulation.step();
    EXPECT_EQ(simulation.state().bonds, simulation.lattice().bonds);
  }
}

// omega^2 dt^2 of the longitudinal and the transverse wave along x, straight from the definition.
struct Frequencies {
  double along = 0.0, across = 0.0;
};

Frequencies frequencies(const Simulation& simulation, double k) {
  const Lattice& lattice = simulation.lattice();
  Frequencies sum;
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double weight, int) {
    const double r2 = a * a + b * b;
    // Twice, for the opposite bond.
    const double share = 2.0 * weight * (1.0 - std::cos(k * a)) / (r2 * std::sqrt(r2));
    sum.along += share * a * a;
    sum.across += share * b * b;
  });
  const double unit =
      lattice.calibration.c * lattice.grid.dx / lattice.rho * simulation.dt() * simulation.dt();
  return {unit * sum.along, unit * sum.across};
}

TEST_P(EveryKernel, APlaneWaveAcceleratesAsTheSymbolSays) {
  Simulation simulation = bare(40, 40);
  const Lattice& lattice = simulation.lattice();
  const double amplitude = 1e-10;  // the kernel is nonlinear: its error is of this order
  for (const double k : {0.1, 0.7, 1.4, 3.0}) {
    simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
      return Vec2(amplitude * std::cos(k * x.x()), amplitude * std::sin(k * x.x()));
    }));
    const Frequencies omega2 = frequencies(simulation, k);
    const std::vector<Vec2> all = test::accelerations(simulation);
    for (int i = 8; i < 32; ++i) {
      const Vec2 a = all[lattice.grid.index(i, 20)] / amplitude;
      const double phase = k * lattice.grid.from_centre(i, 20).x();
      EXPECT_NEAR(a.x(), -omega2.along * std::cos(phase), 2e-10);
      EXPECT_NEAR(a.y(), -omega2.across * std::sin(phase), 2e-10);
    }
    const Branches branches =
        symbol(lattice.family, lattice.calibration.c, lattice.grid.dx, {k, 0.0});
    const double unit = simulation.dt() * simulation.dt() / lattice.rho;
    EXPECT_NEAR(branches.max * unit, std::max(omega2.along, omega2.across), 1e-12);
    EXPECT_NEAR(branches.min * unit, std::min(omega2.along, omega2.across), 1e-12);
  }
}

// sin(omega' dt/2) = omega dt/2 for velocity Verlet (src/solver/README.md 3.2). Edges cannot be
// felt in the middle before n * m rows were crossed.
TEST_P(EveryKernel, APlaneWaveOscillatesWithTheFrequencyOfVelocityVerlet) {
  Simulation simulation = bare(180, 180);
  const double amplitude = 1e-10, k = 0.7;
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
    return Vec2(amplitude * std::cos(k * x.x()), amplitude * std::cos(k * x.x()));
  }));
  const Frequencies omega2 = frequencies(simulation, k);
  const double along = 2.0 * std::asin(0.5 * std::sqrt(omega2.along));
  const double across = 2.0 * std::asin(0.5 * std::sqrt(omega2.across));
  const double start = std::cos(k * simulation.lattice().grid.from_centre(90, 90).x());
  for (int n = 1; n <= 20; ++n) {
    simulation.step();
    const Vec2 u = simulation.state().u(90, 90) / amplitude;
    EXPECT_NEAR(u.x(), start * std::cos(along * n), 1e-8) << n;
    EXPECT_NEAR(u.y(), start * std::cos(across * n), 1e-8) << n;
  }
}

// What is left of all bonds after a step that began with the stretch s everywhere.
std::int64_t bonds_after(Simulation& simulation, double s) {
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) { return Vec2(s * x); }));
  simulation.step();
  return simulation.state().bonds.count();
}

TEST_P(EveryKernel, BondsBreakAboveTheCriticalStretchAndNotBelow) {
  Simulation simulation = bare(20, 20);
  const double s0 = simulation.lattice().calibration.s0;
  EXPECT_EQ(bonds_after(simulation, s0 * (1.0 - 1e-9)), simulation.lattice().bonds.count());
  EXPECT_EQ(bonds_after(simulation, s0 * (1.0 + 1e-9)), 0);
}

TEST_P(EveryKernel, ABondFoundStretchedTooFarPullsNoMoreInTheSameStep) {
  Simulation simulation = bare(20, 20);
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(0.1 * x); }));
  EXPECT_EQ(test::largest(test::accelerations(simulation)), 0.0);
}

TEST_P(EveryKernel, WithLateBreakingItPullsOnceMore) {
  Numerics numerics = test::numerics();
  numerics.breaking = Breaking::next_step;
  Simulation simulation(test::bare_plate(20, 20), numerics, {1, GetParam()});
  const double s0 = simulation.lattice().calibration.s0;
  EXPECT_EQ(bonds_after(simulation, 2.0 * s0), 0);
  // The resultant on the outermost row is that of a bond stretched by 2 s0, times some bonds.
  EXPECT_GT(simulation.state().v(0, 10).x(), s0 * 0.01);
}

TEST_P(EveryKernel, BrokenBondsStayBrokenAndPullNoMore) {
  Simulation simulation = bare(20, 20);
  EXPECT_EQ(bonds_after(simulation, 0.1), 0);
  EXPECT_EQ(bonds_after(simulation, 1e-4), 0);
  EXPECT_EQ(test::largest(test::accelerations(simulation)), 0.0);
}

TEST_P(EveryKernel, CompressionBreaksNothingAndStaysFiniteEvenWhenNodesMeet) {
  for (const Precision precision : {Precision::f64, Precision::f32})
    for (const double s : {-0.01, -0.5, -1.0}) {
      Numerics numerics = test::numerics();
      numerics.precision = precision;
      Simulation simulation(test::bare_plate(20, 20), numerics, {1, GetParam()});
      EXPECT_EQ(bonds_after(simulation, s), simulation.lattice().bonds.count()) << s;
      EXPECT_NO_THROW(simulation.check_finite()) << s;
    }
}

TEST_P(EveryKernel, NoFailZonesHoldWhateverTheStretch) {
  Plate plate = test::bare_plate(20, 20);
  plate.no_fail.push_back(strip(plate, Edge::top, 2e-3));
  Simulation simulation(plate, test::numerics(), {1, GetParam()});
  bonds_after(simulation, 0.5);
  EXPECT_EQ(simulation.state().bonds, simulation.lattice().unbreakable);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EveryKernel,
                         testing::Values(InstructionSet::baseline, InstructionSet::avx2,
                                         InstructionSet::avx512),
                         [](const auto& set) {
                           return std::string(
                               instruction_set_names[static_cast<std::size_t>(set.param)]);
                         });

}  // namespace
}  // namespace hackle
