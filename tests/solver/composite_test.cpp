// SPDX-License-Identifier: MIT
// Plates of several materials and of changing temperature: compared with the same rules written
// down a second time, and with the properties of plain plates.
#include "support/composite.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "lattice/needs.hpp"
#include "measure/energy.hpp"
#include "support/mirror.hpp"
#include "support/reference.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

using test::Mixture;
using test::Reference;

// Returns the largest difference from the reference over the largest acceleration.
double difference(const Simulation& simulation, const std::vector<Reference::Vector>& expected) {
  const std::vector<Vec2> found = test::accelerations(simulation);
  long double worst = 0.0, max = 0.0;
  for (std::size_t node = 0; node < found.size(); ++node) {
    const Reference::Vector error = found[node].cast<Reference::Real>() - expected[node];
    worst = std::max(worst, error.cwiseAbs().maxCoeff());
    max = std::max(max, expected[node].cwiseAbs().maxCoeff());
  }
  return static_cast<double>(worst / max);
}

// Returns the largest difference of the two displacements, in units of dx.
double largest_gap(const Simulation& simulation, const Reference& reference) {
  const Grid& grid = simulation.lattice().grid;
  double worst = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      worst =
          std::max(worst, (simulation.state().u(i, j) - reference.u(i, j).cast<double>()).norm());
  return worst;
}

class Composite : public testing::TestWithParam<Mixture> {
 protected:
  static Numerics in(Precision precision, double m = 3.0) {
    Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
    numerics.precision = precision;
    return numerics;
  }

  // Makes a plate torn apart along a crack, with a no-fail strip at the top.
  static Plate torn(int nx = 60, int ny = 40) {
    Plate plate = test::composite(nx, ny, GetParam());
    plate.cracks.push_back(
        {{0.0, 0.35 * plate.height}, {0.25 * plate.width, 0.35 * plate.height}, Born::broken});
    plate.loads.tractions.push_back({Edge::top, {3e6, 25e6}});
    plate.loads.tractions.push_back({Edge::bottom, {0.0, -25e6}});
    plate.no_fail.push_back(strip(plate, Edge::top, 2e-3));
    return plate;
  }
};

// Tests that a history excludes, or does not affect.
class CompositeWithoutHistory : public Composite {};

// In both precisions, from strains far below the critical stretch to many overstretched bonds, and
// to bonds of half their length.
TEST_P(Composite, AccelerationsAreThoseOfTheReference) {
  for (const double m : {2.0, 3.0, 5.0, 9.0})
    for (const double jolt : {1e-5, 1e-3, 0.25}) {
      Plate plate = torn(45, 50);
      if (jolt > 0.1) plate.material.G0 *= 1e8;
      Simulation exact(plate, in(Precision::f64, m), {1});
      Simulation single(plate, in(Precision::f32, m), {1});
      exact.restore(test::jolted(exact.state(), jolt, 7));
      single.restore(test::jolted(single.state(), jolt, 7));
      const auto expected = Reference(exact).accelerations();
      const std::string what = fmt::format("m = {}, {}", m, jolt);
      // As in reference_test.cpp; thermal strain in single precision adds half an ulp of itself.
      EXPECT_LT(difference(exact, expected), 1e-13) << what;
      EXPECT_LT(difference(single, expected), 4e-6) << what;
    }
}

TEST_P(Composite, TheSameBondsBreakAsInTheReference) {
  Simulation simulation(torn(), in(Precision::f64), {1});
  Reference reference(simulation);
  for (int part = 0; part < 10; ++part) {
    for (int n = 0; n < 20; ++n) {
      reference.take_heat(simulation);
      reference.step();
      simulation.step();
    }
    ASSERT_EQ(reference.differing_bonds(simulation), 0) << "at step " << simulation.state().step;
  }
  EXPECT_GT(simulation.lattice().bonds.count() - simulation.state().bonds.count(), 300);
  EXPECT_LT(largest_gap(simulation, reference), 1e-12);
}

TEST_P(Composite, TheBitsAreTheSameHoweverItIsCarriedOut) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    const auto hash = [&](Execution execution) {
      Simulation simulation(torn(70, 60), in(precision), execution);
      simulation.run(8e-6);
      return simulation.state().hash();
    };
    const std::string alone = hash({1});
    for (const int threads : {2, 5}) EXPECT_EQ(hash({threads}), alone) << threads;
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2})
      if (is_supported(set)) {
        EXPECT_EQ(hash({1, set}), alone);
      }
  }
}

TEST_P(Composite, FusedArithmeticGivesTheSameBitsOnEveryMachineThatHasIt) {
  if (!can_fuse(InstructionSet::avx2) || !is_supported(InstructionSet::avx512))
    GTEST_SKIP() << "one machine only";
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = in(precision);
    numerics.fused = true;
    const auto hash = [&](InstructionSet set) {
      Simulation simulation(torn(), numerics, {2, set});
      simulation.run(8e-6);
      return simulation.state().hash();
    };
    EXPECT_EQ(hash(InstructionSet::avx2), hash(InstructionSet::avx512));
  }
}

// A plate turned by 0.3 rad is too wide for single precision.
TEST_P(CompositeWithoutHistory, ARunInSinglePrecisionGoesOnInDouble) {
  Plate plate = test::composite(45, 50, GetParam());
  Simulation simulation(plate, in(Precision::f32), {1});
  simulation.restore(test::displaced(
      simulation, [](const Vec2& x) { return Vec2(Eigen::Rotation2Dd(0.3) * x - x); }));
  for (int n = 0; n < 64; ++n) simulation.step();
  ASSERT_EQ(simulation.state().precision(), Precision::f64);
  Reference reference(simulation);
  for (int n = 0; n < 20; ++n) {
    reference.take_heat(simulation);
    reference.step();
    simulation.step();
  }
  // Measured: 4e-15 dx; single precision would round u, up to 10 dx, to 1e-6.
  EXPECT_LT(largest_gap(simulation, reference), 1e-12);
}

TEST_P(Composite, AKeptStateGoesOnToTheSameBits) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    // During the ramp of temperature, and after it.
    for (const double moment : {1e-6, 5e-6}) {
      Simulation simulation(torn(), in(precision), {1});
      simulation.run(moment);
      const State kept = simulation.state();
      simulation.run(4e-6);
      const std::string straight = simulation.state().hash();
      const std::int64_t steps = simulation.state().step;
      simulation.restore(kept);
      EXPECT_EQ(simulation.state().hash(), kept.hash());
      while (simulation.state().step < steps) simulation.step();
      EXPECT_EQ(simulation.state().hash(), straight);
    }
  }
}

TEST_P(Composite, MirrorImagesStaySoToTheLastBit) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = test::bare_plate(80, 60);
    const Vec2 middle(0.5 * plate.width, 0.5 * plate.height);
    plate.material.alpha = GetParam().alpha;
    plate.material.alphaT = 4e-6;
    if (GetParam().mixed) {
      plate.inclusions.push_back({test::disc(middle, 4e-3), test::resin()});
      plate.inclusions.push_back(
          {rectangle(Vec2(middle - Vec2(15e-3, 1e-3)), Vec2(middle + Vec2(15e-3, 1e-3))),
           test::steel()});
    }
    if (GetParam().heated)
      plate.loads.thermal_loads.push_back({test::disc(middle, 9e-3), -300.0, ramp(1e-6)});
    plate.cracks.push_back({Vec2(middle - Vec2(7e-3, 0)), Vec2(middle + Vec2(7e-3, 0))});
    plate.loads.tractions.push_back({Edge::top, {0.0, 50e6}});
    plate.loads.tractions.push_back({Edge::bottom, {0.0, -50e6}});
    Simulation simulation(plate, in(precision));
    for (int k = 0; k < 4; ++k) {
      simulation.run(5e-6);
      ASSERT_EQ(test::asymmetric_nodes(simulation, true), 0) << simulation.time();
      ASSERT_EQ(test::asymmetric_nodes(simulation, false), 0) << simulation.time();
    }
    EXPECT_LT(simulation.state().bonds.count(), simulation.lattice().bonds.count() - 300);
  }
}

// Forces are linearised only on plates of one cold material.
TEST_P(CompositeWithoutHistory, FidelityFallsBackToTheExactForce) {
  Numerics numerics = in(Precision::f64);
  const auto hash = [&] {
    Simulation simulation(torn(), numerics, {1});
    simulation.run(6e-6);
    EXPECT_EQ(simulation.path_counts()[static_cast<int>(Path::linear)], 0);
    return simulation.state().hash();
  };
  const std::string exact = hash();
  numerics.fidelity = 1.0;
  EXPECT_EQ(hash(), exact);
}

// Returns the largest residual share of the ledger in some microseconds without breaking.
double leak(const Mixture& mixture, double dt) {
  Plate plate = test::composite(40, 30, mixture);
  plate.no_fail.push_back(strip(plate, Edge::top, plate.height));
  plate.loads.tractions.push_back({Edge::top, {1e6, 2e6}});
  Numerics numerics = test::numerics(0.5e-3, 1.5e-3);
  numerics.step = dt;
  Simulation simulation(plate, numerics);
  double worst = 0.0, max = 0.0;
  while (simulation.time() < 6e-6) {
    simulation.step();
    const Energy now = energy(simulation);
    worst = std::max(worst, std::abs(now.residual()));
    max = std::max(max, now.strain);
  }
  return worst / max;
}

TEST_P(CompositeWithoutHistory, TheLedgerClosesWithTheSquareOfTheStep) {
  const double coarse = leak(GetParam(), 30e-9), fine = leak(GetParam(), 15e-9);
  EXPECT_LT(fine, 2e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.8);
}

TEST_P(Composite, MemoryIsWhatWasSaid) {
  const Simulation simulation(torn(400, 300), in(Precision::f64), {1});
  EXPECT_EQ(static_cast<double>(simulation.bytes()),
            memory_of(simulation.plate(), simulation.numerics()).kept);
}

std::string name_of(const Mixture& mixture) {
  return fmt::format("{}{}{}", mixture.mixed ? "mixed" : "", mixture.heated ? "heated" : "",
                     mixture.alpha > 0.0 ? "_history" : "");
}

INSTANTIATE_TEST_SUITE_P(Mixtures, CompositeWithoutHistory,
                         testing::Values(Mixture{true, false, 0.0}, Mixture{false, true, 0.0},
                                         Mixture{true, true, 0.0}),
                         [](const auto& mixture) { return name_of(mixture.param); });

INSTANTIATE_TEST_SUITE_P(Mixtures, Composite,
                         testing::Values(Mixture{true, false, 0.0}, Mixture{false, true, 0.0},
                                         Mixture{true, true, 0.0}, Mixture{true, false, 0.25},
                                         Mixture{false, true, 0.25}, Mixture{true, true, 0.25}),
                         [](const auto& mixture) { return name_of(mixture.param); });

}  // namespace
}  // namespace hackle
