// SPDX-License-Identifier: MIT
// What a force kernel must do for given displacements (physics.md 5.1, 5.3, 5.13).
#include "solver/kernel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lattice/symbol.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

struct Inner {
  double most = 0.0;  // largest component of the acceleration of nodes farther than m from the rim
};

Inner inner_acceleration(const Simulation& simulation) {
  const Grid& grid = simulation.lattice().grid;
  const int reach = simulation.lattice().family.reach();
  Inner inner;
  for (int j = reach; j < grid.ny - reach; ++j)
    for (int i = reach; i < grid.nx - reach; ++i) {
      const std::size_t node = grid.index(i, j);
      inner.most = std::max({inner.most, std::abs(simulation.state().ax[node]),
                             std::abs(simulation.state().ay[node])});
    }
  return inner;
}

class EveryKernel : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (!is_supported(GetParam()))
      GTEST_SKIP() << instruction_set_names[static_cast<std::size_t>(GetParam())];
  }
  Simulation bare(int nx, int ny, double m = 4.0) const {
    return Simulation(test::bare_plate(nx, ny), test::numerics(0.5e-3, m * 0.5e-3),
                      {1, GetParam()});
  }
};

TEST_P(EveryKernel, RigidTranslationMakesNoForceAtAll) {
  Simulation simulation = bare(23, 19);
  simulation.restore(test::displaced(simulation, [](const Vec2&) { return Vec2(0.3, -7.1); }));
  for (const double a : simulation.state().ax) EXPECT_EQ(a, 0.0);
  for (const double a : simulation.state().ay) EXPECT_EQ(a, 0.0);
}

TEST_P(EveryKernel, RigidRotationStretchesNothing) {
  Simulation simulation = bare(23, 19);
  const double angle = 0.7;
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
    return Vec2(std::cos(angle) * x.x() - std::sin(angle) * x.y() - x.x(),
                std::sin(angle) * x.x() + std::cos(angle) * x.y() - x.y());
  }));
  EXPECT_EQ(simulation.state().bonds, simulation.lattice().bonds);
  // Rounding of u, about 12 eps, relative to a stretch of 1 that would give accelerations of
  // order 1.
  EXPECT_LT(inner_acceleration(simulation).most, 1e-13);
}

TEST_P(EveryKernel, UniformStrainLeavesInnerNodesInBalance) {
  for (const double m : {2.0, 3.0, 4.0, 6.0, 9.0}) {
    Simulation simulation = bare(31, 29, m);
    simulation.restore(test::displaced(simulation, [](const Vec2& x) {
      return Vec2(4e-4 * x.x() + 2e-4 * x.y(), -3e-4 * x.x() + 1e-4 * x.y());
    }));
    EXPECT_EQ(simulation.state().bonds, simulation.lattice().bonds);
    EXPECT_LT(inner_acceleration(simulation).most, 1e-15) << m;  // forces are of order 1e-3
  }
}

// omega^2 dt^2 of the longitudinal and the transverse wave along x, straight from the definition.
struct Frequencies {
  double along = 0.0, across = 0.0;
};

Frequencies frequencies(const Simulation& simulation, double k) {
  const Lattice& lattice = simulation.lattice();
  Frequencies sum;
  lattice.family.for_each_bond([&](int a, int b, double weight, int) {
    const double r2 = a * a + b * b;
    const double share = weight * (1.0 - std::cos(k * a)) / (r2 * std::sqrt(r2));
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
    for (int i = 8; i < 32; ++i) {
      const std::size_t node = lattice.grid.index(i, 20);
      const double phase = k * lattice.grid.from_centre(i, 20).x();
      const State& state = simulation.state();
      EXPECT_NEAR(state.ax[node] / amplitude, -omega2.along * std::cos(phase), 2e-10);
      EXPECT_NEAR(state.ay[node] / amplitude, -omega2.across * std::sin(phase), 2e-10);
    }
    const Branches branches =
        symbol(lattice.family, lattice.calibration.c, lattice.grid.dx, {k, 0.0});
    const double unit = simulation.dt() * simulation.dt() / lattice.rho;
    EXPECT_NEAR(branches.most * unit, std::max(omega2.along, omega2.across), 1e-12);
    EXPECT_NEAR(branches.least * unit, std::min(omega2.along, omega2.across), 1e-12);
  }
}

// sin(omega' dt/2) = omega dt/2 for velocity Verlet (physics.md 5.1). Edges cannot be felt in the
// middle before n * m rows were crossed.
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
  const auto at = static_cast<std::size_t>(simulation.state().layout.at(90, 90));
  for (int n = 1; n <= 20; ++n) {
    simulation.step();
    const State& state = simulation.state();
    EXPECT_NEAR(state.ux[at] / amplitude, start * std::cos(along * n), 1e-8) << n;
    EXPECT_NEAR(state.uy[at] / amplitude, start * std::cos(across * n), 1e-8) << n;
  }
}

TEST_P(EveryKernel, BondsBreakAboveTheCriticalStretchAndNotBelow) {
  Simulation simulation = bare(20, 20);
  const double s0 = simulation.lattice().calibration.s0;
  const auto stretch = [&](double s) {
    simulation.restore(test::displaced(simulation, [&](const Vec2& x) { return Vec2(s * x); }));
    return simulation.state().bonds.count();
  };
  EXPECT_EQ(stretch(s0 * (1.0 - 1e-9)), simulation.lattice().bonds.count());
  EXPECT_EQ(stretch(s0 * (1.0 + 1e-9)), 0);
}

TEST_P(EveryKernel, BrokenBondsStayBrokenAndPullNoMore) {
  Simulation simulation = bare(20, 20);
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(0.1 * x); }));
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(1e-4 * x); }));
  EXPECT_EQ(simulation.state().bonds.count(), 0);
  for (const double a : simulation.state().ax) EXPECT_EQ(a, 0.0);
}

TEST_P(EveryKernel, CompressionBreaksNothingAndStaysFiniteEvenWhenNodesMeet) {
  Simulation simulation = bare(20, 20);
  for (const double s : {-0.01, -0.5, -1.0}) {
    simulation.restore(test::displaced(simulation, [&](const Vec2& x) { return Vec2(s * x); }));
    EXPECT_EQ(simulation.state().bonds, simulation.lattice().bonds) << s;
    for (const double a : simulation.state().ax) EXPECT_TRUE(std::isfinite(a)) << s;
  }
}

TEST_P(EveryKernel, NoFailZonesHoldWhateverTheStretch) {
  Plate plate = test::bare_plate(20, 20);
  plate.no_fail.push_back(strip(plate, Edge::top, 2e-3));
  Simulation simulation(plate, test::numerics(), {1, GetParam()});
  simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(0.5 * x); }));
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
