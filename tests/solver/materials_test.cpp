// SPDX-License-Identifier: MIT
// Plates of several materials.
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/energy.hpp"
#include "support/composite.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// An inclusion of the plate's own material changes nothing.
TEST(Materials, OneMaterialByTwoNamesIsOne) {
  Plate plate = test::edge_crack(24e6);
  const auto hash = [&] {
    Simulation simulation(plate, test::numerics(), {1});
    simulation.run(10e-6);
    return simulation.state().hash();
  };
  const std::string plain = hash();
  plate.inclusions.push_back({test::disc({0.06, 0.02}, 5e-3), plate.material});
  EXPECT_EQ(hash(), plain);
}

// Uses the kernels for several materials; factors of 1 round nothing.
TEST(Materials, ASecondMaterialThatNoNodeIsOfChangesNoBit) {
  Plate plate = test::edge_crack(24e6);
  const auto hash = [&](const Numerics& numerics) {
    Simulation simulation(plate, numerics, {1});
    simulation.run(10e-6);
    return simulation.state().hash();
  };
  Numerics numerics = test::numerics();
  numerics.step = 200e-9;
  const std::string plain = hash(numerics);
  Material other = plate.material;
  other.G0 *= 2.0;
  plate.inclusions.push_back({test::disc({50e-3, 20e-3}, 0.1e-3), other});
  EXPECT_EQ(hash(numerics), plain);
}

// A pulse along a bar of 1 by 1600 nodes, glass on the left of its middle.
struct Pulse {
  explicit Pulse(const Material& right) : plate(test::bare_plate(nodes, 1)) {
    plate.inclusions.push_back(
        {rectangle({0.5 * plate.width, 0.0}, {plate.width, plate.height}), right});
  }
  // Returns the largest u on either side once the pulse has passed the middle, over that at the
  // start.
  std::pair<double, double> reflected_and_transmitted() const {
    Simulation simulation(plate, test::numerics(0.5e-3, 1.5e-3), {1});
    const Lattice& lattice = simulation.lattice();
    double speed2 = 0.0;  // of long waves in the glass, squared, in spacings per step
    lattice.family.for_each_bond([&](int a, int b, const Vec2&, double weight, int) {
      if (b == 0) speed2 += weight * std::abs(a);
    });
    const double dt = simulation.dt();
    const double speed =
        std::sqrt(speed2 * lattice.calibration.c * lattice.grid.dx * dt * dt / lattice.rho);
    const auto shape = [](double x) { return 1e-6 * std::exp(-0.5 * x * x / (width * width)); };
    State state =
        test::displaced(simulation, [&](const Vec2& x) { return Vec2(shape(x.x() - start), 0); });
    for (int i = 0; i < nodes; ++i) {
      const double x = lattice.grid.from_centre(i, 0).x() - start;
      state.set_v(i, 0, {speed * x / (width * width) * shape(x), 0});
    }
    simulation.restore(state);
    for (int n = 0; n < static_cast<int>(2.0 * -start / speed); ++n) simulation.step();
    std::pair<double, double> max{0.0, 0.0};
    for (int i = 0; i < nodes; ++i) {
      const double u = simulation.state().u(i, 0).x() / 1e-6;
      double& side = i < nodes / 2 ? max.first : max.second;
      if (std::abs(u) > std::abs(side)) side = u;
    }
    return max;
  }

  static constexpr int nodes = 1600;
  static constexpr double start = -300.0, width = 30.0;  // spacings, from the middle
  Plate plate;
};

// With impedances Z = sqrt(E rho), a displacement wave is reflected by (Z1 - Z2)/(Z1 + Z2) and
// transmitted by 2 Z1/(Z1 + Z2). Lattice waves of length 2 pi 30 spacings are slower by at most
// 1e-3.
TEST(Materials, WavesAreReflectedByTheRatioOfImpedances) {
  for (const Material& right : {test::steel(), test::resin()}) {
    const Pulse pulse(right);
    const Material& left = pulse.plate.material;
    const double z1 = std::sqrt(left.E * left.rho), z2 = std::sqrt(right.E * right.rho);
    const auto [reflected, transmitted] = pulse.reflected_and_transmitted();
    EXPECT_NEAR(reflected, (z1 - z2) / (z1 + z2), 0.01) << right.name;
    EXPECT_NEAR(transmitted, 2.0 * z1 / (z1 + z2), 0.01) << right.name;
  }
}

// Returns the largest omega^2 dt^2 of all modes of the linearised plate, from its response to every
// displacement.
double largest_frequency(const Simulation& simulation) {
  constexpr double small = 1e-7;
  const Grid& grid = simulation.lattice().grid;
  const auto count = static_cast<Eigen::Index>(2 * grid.nodes());
  Eigen::MatrixXd response(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    Simulation probe = simulation;
    State state = probe.state();
    const int node = static_cast<int>(k / 2);
    state.set_u(node % grid.nx, node / grid.nx, k % 2 == 0 ? Vec2(small, 0) : Vec2(0, small));
    probe.restore(state);
    const std::vector<Vec2> a = test::accelerations(probe);
    for (Eigen::Index n = 0; n < count; ++n)
      response(n, k) = -a[static_cast<std::size_t>(n / 2)][n % 2] / small;
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(response, false);
  double max = 0.0;
  for (Eigen::Index k = 0; k < count; ++k) max = std::max(max, modes.eigenvalues()[k].real());
  return max;
}

TEST(Materials, NoModeIsFasterThanTheStepLimitAllows) {
  for (const double E : {5e9, 65e9, 400e9})
    for (const double rho : {500.0, 2235.0, 20000.0}) {
      Plate plate = test::bare_plate(9, 7);
      Material other = plate.material;
      other.E = E;
      other.rho = rho;
      plate.inclusions.push_back({rectangle({2e-3, 0.0}, {3.1e-3, 2.6e-3}), other});
      const Simulation simulation(plate, test::numerics(0.5e-3, 1e-3), {1});
      const double share = simulation.lattice().step_limit / simulation.dt();
      // 1e-6 for nonlinear terms at a displacement of 1e-7.
      EXPECT_LT(largest_frequency(simulation) * share * share, 4.0 * (1.0 + 1e-6))
          << E << " " << rho;
    }
}

// Returns kinetic and strain energy after many steps at a share of the limit, relative to the
// start.
double growth(double share) {
  Numerics numerics = test::numerics(0.5e-3, 1.5e-3);
  Plate plate = test::composite(48, 40, {.mixed = true});
  plate.inclusions.front().material.E = plate.inclusions.back().material.E;  // stiff and light
  const Simulation probe(plate, numerics);
  numerics.step = share * probe.lattice().step_limit;
  numerics.force_step = true;
  Simulation simulation(plate, numerics);
  simulation.restore(test::shaken(simulation.state(), 1e-9, 1));
  const double start = energy(simulation).kinetic;
  for (int n = 0; n < 2000; ++n) simulation.step();
  const Energy end = energy(simulation);
  return (end.kinetic + end.strain) / start;
}

TEST(Materials, TheStepLimitHolds) {
  EXPECT_LT(growth(0.98), 30.0);      // see stability_test.cpp
  const double beyond = growth(1.1);  // the disc is too small for the longest of the short waves
  EXPECT_TRUE(!std::isfinite(beyond) || beyond > 1e6) << beyond;
}

TEST(Materials, AStepAboveTheLimitOfAnInclusionIsRefused) {
  Plate plate = test::bare_plate(40, 30);
  Numerics numerics = test::numerics();
  numerics.step = 200e-9;
  EXPECT_NO_THROW(Simulation(plate, numerics, {1}));
  Material stiff = plate.material;
  stiff.E *= 4.0;
  plate.inclusions.push_back({test::disc({10e-3, 7e-3}, 3e-3), stiff});
  try {
    Simulation simulation(plate, numerics, {1});
    FAIL() << "the limit is 116 ns";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("above the stability limit"));
  }
}

// A body with a uniform stretch along y between glass and a material of half its critical stretch.
TEST(Materials, ABondBetweenTwoBreaksByTheWeaker) {
  Plate plate = test::bare_plate(20, 20);
  Material weak = plate.material;
  weak.G0 *= 0.25;
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {plate.width, 0.5 * plate.height}), weak});
  Simulation simulation(plate, test::numerics(), {1});
  const double s = 0.75 * simulation.lattice().calibration.s0;
  simulation.restore(
      test::displaced(simulation, [&](const Vec2& x) { return Vec2(0, s * x.y()); }));
  simulation.step();
  for (int j = 0; j + 1 < 20; ++j) EXPECT_EQ(simulation.holds(10, j, 0, 1), j >= 10) << j;
  EXPECT_TRUE(simulation.holds(10, 12, 1, 0));
  // Broken bonds take the energy of the weaker material: a quarter.
  const Energy now = energy(simulation);
  EXPECT_GT(now.broken, 0.0);
}

// Momentum includes the masses: it is constant in a free body of several materials.
TEST(Materials, MomentumIsConserved) {
  Simulation simulation(test::composite(50, 40, {.mixed = true}), test::numerics(), {1});
  simulation.restore(test::shaken(simulation.state(), 1e-6, 3));
  const auto momentum = [&] {
    Vec2 sum(0, 0);
    const Lattice& lattice = simulation.lattice();
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 50; ++i)
        if (!lattice.is_void(i, j))
          sum += lattice.material_at(i, j).material.rho / lattice.rho * simulation.state().v(i, j);
    return sum;
  };
  const Vec2 before = momentum();
  for (int n = 0; n < 300; ++n) simulation.step();
  ASSERT_EQ(simulation.state().bonds, simulation.lattice().bonds);
  // 2000 nodes, 300 steps, random rounding errors of eps of a velocity each.
  EXPECT_LT((momentum() - before).norm(), 1e-6 * 1e-12);
}

}  // namespace
}  // namespace hackle
