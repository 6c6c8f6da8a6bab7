// SPDX-License-Identifier: MIT
// The engine works in lattice units: a problem with the same dimensionless numbers has the same
// solution, whatever its size, stiffness and density. Factors that are powers of two (of four under
// a square root) are exact, and the solution is then equal to the last bit.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/outcome.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

struct Scale {
  double dx = 0x1p-11;  // m
  double E = 0x1p36;    // Pa
  double rho = 0x1p11;  // kg/m3
};

// Makes an edge crack in 60 x 40 nodes under `load` times the strength E s0, with s0 = 1e-3.
Plate plate_of(const Scale& scale, double load, double alpha) {
  Plate plate;
  plate.width = 60.0 * scale.dx;
  plate.height = 40.0 * scale.dx;
  plate.material = {"test", scale.E, scale.rho, 0.25, 0x1p-19 * scale.E * scale.dx, alpha};
  plate.cracks.push_back(
      {{0.0, 20.0 * scale.dx}, {24.0 * scale.dx, 20.0 * scale.dx}, Born::broken});
  plate.loads.tractions.push_back({Edge::top, {0.0, load * 0x1p-10 * scale.E}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -load * 0x1p-10 * scale.E}});
  plate.no_fail.push_back(strip(plate, Edge::top, 4.0 * scale.dx));
  plate.no_fail.push_back(strip(plate, Edge::bottom, 4.0 * scale.dx));
  return plate;
}

Numerics numerics_of(const Scale& scale, Precision precision) {
  Numerics numerics;
  numerics.spacing = scale.dx;
  numerics.precision = precision;
  return numerics;
}

Simulation solve(const Scale& scale, Precision precision, double load = 0.25, double alpha = 0.0) {
  const Plate plate = plate_of(scale, load, alpha);
  Numerics numerics = numerics_of(scale, precision);
  numerics.step = 0.875 * Simulation(plate, numerics, {1}).lattice().step_limit;
  Simulation simulation(plate, numerics, {1});
  simulation.run(150.0 * simulation.dt());
  test::expect_numbers(simulation, fmt::format("dx {} E {} rho {}", scale.dx, scale.E, scale.rho));
  return simulation;
}

// Spacing from 0.2 nm to 16 m, 1e-3 to 1e15 Pa, 1e-6 to 1e8 kg/m3.
constexpr Scale exact_scales[] = {
    {0x1p-32, 0x1p36, 0x1p11},  {0x1p4, 0x1p36, 0x1p11},    {0x1p-11, 0x1p-10, 0x1p11},
    {0x1p-11, 0x1p50, 0x1p11},  {0x1p-11, 0x1p36, 0x1p-19}, {0x1p-11, 0x1p36, 0x1p27},
    {0x1p-32, 0x1p50, 0x1p-19}, {0x1p4, 0x1p-10, 0x1p27},
};

class Scales : public testing::TestWithParam<Precision> {};

TEST_P(Scales, ThatArePowersOfTwoGiveTheSameBits) {
  for (const double alpha : {0.0, 0.25}) {
    const Simulation usual = solve({}, GetParam(), 0.25, alpha);
    EXPECT_GT(count_damage(usual).broken_bonds, 200);
    for (const Scale& scale : exact_scales)
      EXPECT_EQ(solve(scale, GetParam(), 0.25, alpha).state().hash(), usual.state().hash())
          << "dx " << scale.dx << ", E " << scale.E << ", rho " << scale.rho;
  }
}

// Any other factors round the tables, by 1e-16 (f32: 6e-8), which grows by at most 1e4 before the
// crack forks.
TEST_P(Scales, OfAnySizeGiveTheSameBondsAndDisplacements) {
  const Simulation usual = solve({}, GetParam());
  double max = 0.0;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 60; ++i) max = std::max(max, usual.state().u(i, j).norm());
  for (const Scale& scale :
       {Scale{1e-9, 70e9, 2200.0}, Scale{13.0, 70e9, 2200.0}, Scale{1e-3, 1e-3, 2200.0},
        Scale{1e-3, 1e15, 2200.0}, Scale{1e-3, 70e9, 1e-6}, Scale{1e-3, 70e9, 1e8}}) {
    const Simulation other = solve(scale, GetParam());
    EXPECT_EQ(other.state().bonds, usual.state().bonds);
    double worst = 0.0;
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 60; ++i)
        worst = std::max(worst, (other.state().u(i, j) - usual.state().u(i, j)).norm());
    EXPECT_LT(worst / max, GetParam() == Precision::f64 ? 1e-12 : 6e-4);
  }
}

// Without breaking the response deviates from linearity by a few strains, which here are 4 times
// the load over E, and by rounding, which is relative in every number.
TEST_P(Scales, OfTheLoadAreFollowedDownToATrillionthOfTheStrength) {
  const auto scaled = [&](double load) {
    const Simulation simulation = solve({}, GetParam(), load);
    EXPECT_EQ(count_damage(simulation).broken_bonds, 0);
    std::vector<Vec2> u;
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 60; ++i) u.emplace_back(simulation.state().u(i, j) / load);
    return u;
  };
  const std::vector<Vec2> min = scaled(0x1p-40);
  double size = 0.0;
  for (const Vec2& u : min) size = std::max(size, u.norm());
  for (const double load : {0x1p-33, 0x1p-27, 0x1p-20, 0x1p-13, 0x1p-7}) {
    const std::vector<Vec2> now = scaled(load);
    double worst = 0.0;
    for (std::size_t node = 0; node < now.size(); ++node)
      worst = std::max(worst, (now[node] - min[node]).norm());
    const double rounding = GetParam() == Precision::f64 ? 1e-13 : 1e-5;
    EXPECT_LT(worst / size, rounding + 100.0 * load * 0x1p-10) << load;
  }
}

// Everything breaks, and yet momentum is force times time.
TEST_P(Scales, OfTheLoadUpToAThousandTimesTheStrengthShatterButKeepMomentum) {
  for (const double load : {1.0, 10.0, 100.0, 1000.0}) {
    Plate plate = plate_of({}, load, 0.0);
    plate.no_fail.clear();
    plate.loads.tractions.pop_back();  // otherwise it would be 0
    Simulation simulation(plate, numerics_of({}, GetParam()), {1});
    simulation.run(150.0 * simulation.dt());
    test::expect_numbers(simulation, fmt::format("load {}", load));
    EXPECT_GT(count_damage(simulation).broken_bonds, 200);
    const Lattice& lattice = simulation.lattice();
    const double dt = simulation.dt();
    Vec2 force(0, 0), momentum(0, 0);
    for (const LoadedNode& node : simulation.actions().forces)
      force += node.acceleration * dt * dt / lattice.grid.dx;
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 60; ++i) momentum += simulation.state().v(i, j);
    // v lags by half a step. 2400 nodes round 150 times.
    const Vec2 expected = force * (150.0 - 0.5);
    EXPECT_LT((momentum - expected).norm() / expected.norm(),
              GetParam() == Precision::f64 ? 1e-13 : 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Precisions, Scales, testing::Values(Precision::f64, Precision::f32),
                         [](const auto& precision) {
                           return std::string(name_of(precision.param));
                         });

}  // namespace
}  // namespace hackle
