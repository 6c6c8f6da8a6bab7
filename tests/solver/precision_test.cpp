// SPDX-License-Identifier: MIT
// Errors of single precision, and numbers too small for either precision.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "solver/f32_range.hpp"
#include "solver/simulation.hpp"
#include "support/agreement.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Numerics single() {
  Numerics numerics = test::numerics();
  numerics.precision = Precision::f32;
  return numerics;
}

// src/solver/README.md 5.1: 2e-7 at this spacing.
TEST(SinglePrecision, BreaksTheSameBondsAsDoublePrecision) {
  Simulation exact(test::edge_crack(12e6), test::numerics()),
      rounded(test::edge_crack(12e6), single());
  exact.run(32e-6);
  rounded.run(32e-6);
  EXPECT_LT(exact.state().bonds.count(), exact.lattice().bonds.count() - 3000);
  EXPECT_TRUE(exact.state().bonds == rounded.state().bonds);
  EXPECT_LT(test::relative_difference(exact, rounded), 2e-6);
  EXPECT_FALSE(rounded.widened_at());
}

// At 1e-3 dx per step the plate drifts by 5 dx: more than f32 can represent in u.
TEST(SinglePrecision, BearsADriftOfTheWholePlate) {
  Plate whole = test::bare_plate(30, 20), holed = whole;
  holed.cutouts.push_back({rectangle({1e-3, 1e-3}, {4e-3, 7e-3}), ""});  // which does not move
  const auto drift = [](const Plate& plate, Precision precision) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {1});
    const State state = test::thrown(simulation, [](const Vec2&) { return Vec2(1e-3, -5e-4); });
    simulation.restore(test::shaken(state, 1e-5, 3));
    for (int n = 0; n < 5000; ++n) simulation.step();
    return simulation;
  };
  for (const Plate& plate : {whole, holed}) {
    const Simulation exact = drift(plate, Precision::f64), rounded = drift(plate, Precision::f32);
    EXPECT_FALSE(rounded.widened_at());
    EXPECT_NEAR(rounded.state().origin.x(), 5.0, 0.05);
    // v rounds randomly by 6e-11 of a step's displacement, 5000 times: 2e-7 of all 5 dx once, and
    // as much again from u. The remaining vibration, 1e-5 in 5 steps, is not compared to the bit.
    EXPECT_LT(test::relative_difference(exact, rounded), 1e-5);
    EXPECT_EQ(rounded.state().bonds, rounded.lattice().bonds);
  }
}

TEST(SinglePrecision, GoesOverToDoubleWhenThePlateGrowsTooWide) {
  Simulation simulation(test::bare_plate(30, 20), single(), {1});
  simulation.restore(test::thrown(simulation, [](const Vec2& x) { return Vec2(0.1 * x); }));
  const double s0 = simulation.lattice().calibration.s0;
  while (simulation.state().step < 2000 && !simulation.widened_at()) simulation.step();
  ASSERT_TRUE(simulation.widened_at());
  EXPECT_EQ(simulation.state().precision(), Precision::f64);
  // 6e-8 of the half width of u exceeds the rounding allowed.
  EXPECT_GT(simulation.state().u(29, 19).norm() * 6e-8, max_rounding * s0);
  simulation.run(10.0 * simulation.dt());
  EXPECT_NO_THROW(simulation.check_finite());
}

class Denormals : public testing::TestWithParam<Precision> {
 protected:
  Simulation loaded_on_top() const {
    Plate plate = test::bare_plate(100, 400);
    plate.loads.tractions.push_back({Edge::top, {0.0, 1e6}});
    Numerics numerics = test::numerics();
    numerics.precision = GetParam();
    return Simulation(plate, numerics, {2});
  }
  // Returns the smallest normal number of the precision.
  double min() const {
    return GetParam() == Precision::f64 ? std::numeric_limits<double>::min()
                                        : std::numeric_limits<float>::min();
  }
};

TEST_P(Denormals, AreFlushedInTheStepOnly) {
  volatile double tiny = std::numeric_limits<double>::min();
#ifdef __SSE__
  constexpr unsigned flags = 0x3F;  // of exceptions, which remain set
  const unsigned before = _mm_getcsr() & ~flags;
#endif
  Simulation simulation = loaded_on_top();
  for (int n = 0; n < 5; ++n) simulation.step();
  EXPECT_GT(simulation.velocities().size(), 0U);
#ifdef __SSE__
  EXPECT_EQ(_mm_getcsr() & ~flags, before);
#endif
  EXPECT_GT(0.25 * tiny, 0.0);
}

TEST_P(Denormals, AreNeverInAState) {
  Simulation simulation = loaded_on_top();
  for (int part = 0; part < 4; ++part) {
    for (int n = 0; n < 15; ++n) simulation.step();
    for (int j = 0; j < 400; ++j)
      for (int i = 0; i < 100; ++i)
        for (const Vec2& value : {simulation.state().u(i, j), simulation.state().v(i, j)})
          for (const double x : {std::abs(value.x()), std::abs(value.y())})
            EXPECT_TRUE(x == 0.0 || x >= min()) << i << ", " << j;
  }
}

// A load advances by m rows per step.
TEST_P(Denormals, AheadOfTheWaveAllIsExactlyZeroAndStill) {
  Simulation simulation = loaded_on_top();
  for (int n = 1; n <= 20; ++n) {
    simulation.step();
    for (int j = 0; j < 400 - 4 * n; ++j)
      for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(simulation.state().u(i, j), Vec2(0, 0));
        ASSERT_EQ(simulation.state().v(i, j), Vec2(0, 0));
      }
  }
  const PathCounts& counts = simulation.path_counts();
  std::int64_t all = 0;
  for (const std::int64_t count : counts) all += count;
  // 50 by 8 tiles, because a border of two groups of 16 columns lies on the midline. The wave
  // covers 80 of 400 rows, half of them on average, and two more tiles.
  EXPECT_EQ(all, 20 * 50 * 8);
  EXPECT_GT(counts[static_cast<int>(Path::still)], all * 8 / 10);
}

INSTANTIATE_TEST_SUITE_P(Precisions, Denormals, testing::Values(Precision::f64, Precision::f32),
                         [](const auto& precision) {
                           return std::string(name_of(precision.param));
                         });

}  // namespace
}  // namespace hackle
