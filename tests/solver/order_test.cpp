// SPDX-License-Identifier: MIT
// A scene does not depend on the order of its statements, except where the order has a meaning.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// Returns hashes after a few steps of a plate on which `put` places five things in ten orders.
template <class Put>
std::set<std::string> hashes(Precision precision, const Put& put) {
  std::set<std::string> found;
  std::vector<int> order{0, 1, 2, 3, 4};
  for (int turn = 0; turn < 10; ++turn) {
    Plate plate = test::bare_plate(12, 10);
    plate.material.alphaT = 9e-6;
    for (const int k : order) put(plate, k);
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {1});
    for (int step = 0; step < 4; ++step) simulation.step();
    found.insert(simulation.state().hash());
    for (int skip = 0; skip <= 11 * turn % 13; ++skip) std::ranges::next_permutation(order);
  }
  return found;
}

// Values whose plain sums depend on the order.
constexpr std::array odd{1.1, 2.3, -0.7, 3.1, 0.9};

Shape max_of(const Plate& plate, int k) {
  return strip(plate, Edge::top, plate.height * (0.5 + 0.1 * k));
}

class Order : public testing::TestWithParam<Precision> {};

TEST_P(Order, OfForcesMeansNothing) {
  const auto put = [](Plate& plate, int k) {
    const double own = odd.at(static_cast<std::size_t>(k));
    plate.loads.tractions.push_back({Edge::top, Vec2(own / 3 * 1e6, own * 1e6), 0.0, {}});
    plate.loads.body_forces.push_back(
        {max_of(plate, k), Vec2(own * 1e7, own / 7 * 1e7), k % 2 == 0 ? ramp(1e-6) : Amplitude()});
  };
  EXPECT_EQ(hashes(GetParam(), put).size(), 1U);
}

TEST_P(Order, OfTemperaturesMeansNothing) {
  const auto put = [](Plate& plate, int k) {
    const double own = odd.at(static_cast<std::size_t>(k));
    plate.loads.thermal_loads.push_back(
        {max_of(plate, k), own * 100.0 / 3, k % 2 == 0 ? ramp(1e-6) : Amplitude()});
  };
  EXPECT_EQ(hashes(GetParam(), put).size(), 1U);
}

TEST_P(Order, OfStartsMeansNothing) {
  const auto put = [](Plate& plate, int k) {
    const double own = odd.at(static_cast<std::size_t>(k));
    plate.initial_conditions.push_back(
        {max_of(plate, k), Vec2(own * 1e-8 / 3, own * 1e-8 / 7), Vec2(own / 3, own / 11)});
  };
  EXPECT_EQ(hashes(GetParam(), put).size(), 1U);
}

TEST_P(Order, OfCracksZonesAndCutoutsMeansNothing) {
  const auto put = [](Plate& plate, int k) {
    const double x = plate.width * (0.15 + 0.17 * k);
    plate.cracks.push_back(Crack({x, 0.3 * plate.height}, {x + 0.05 * plate.width, plate.height},
                                 k % 2 == 0 ? Born::broken : Born::absent));
    plate.cutouts.push_back(
        {Ellipse{{x, 0.1 * plate.height}, Vec2::Constant(0.12 * plate.width)}, ""});
    plate.no_fail.push_back(
        Shape{Ellipse{{x, 0.8 * plate.height}, Vec2::Constant(0.1 * plate.width)}});
    plate.loads.body_forces = {{std::nullopt, Vec2(1e9, 2e9), {}}};
  };
  EXPECT_EQ(hashes(GetParam(), put).size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Precisions, Order, testing::Values(Precision::f64, Precision::f32));

// Heating and cooling may each be too large if their sum is not.
TEST(Order, OfHeatAndColdThatTakeEachOtherBackMeansNothing) {
  Plate plate = test::bare_plate(12, 10);
  plate.material.alphaT = 1e-3;
  for (const double change : {90.0, 90.0, -120.0})
    plate.loads.thermal_loads.push_back({std::nullopt, change, {}});
  EXPECT_NO_THROW(Simulation(plate, test::numerics(), {1}));
}

// The sum of mirrored loads is the mirror image of their sum.
TEST(Order, OfAMirrorImageIsTheSame) {
  const auto run = [](double sign) {
    Plate plate = test::bare_plate(12, 10);
    for (const double own : odd) {
      plate.loads.body_forces.push_back({std::nullopt, Vec2(sign * own * 1e7, 0.0), {}});
      plate.loads.body_forces.push_back({std::nullopt, Vec2(-sign * own * 1e7, 0.0), {}});
      plate.loads.body_forces.push_back({std::nullopt, Vec2(sign * own * 1e6 / 3, 0.0), {}});
    }
    Simulation simulation(plate, test::numerics(), {1});
    for (int step = 0; step < 4; ++step) simulation.step();
    return simulation.displacement(5, 5);
  };
  EXPECT_EQ(run(1.0), -run(-1.0));
  EXPECT_NE(run(1.0).x(), 0.0);
}

}  // namespace
}  // namespace hackle
