// SPDX-License-Identifier: MIT
#include "output/report/load_remarks.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "base/units.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double dt = 0.2e-6, end = 40e-6;
constexpr double forever = std::numeric_limits<double>::infinity();

double swing(const Amplitude& amplitude, double begin = 0.0) {
  return shortest_swing(amplitude, begin, end, dt);
}

Amplitude function(std::function<double(double)> factor) {
  return Amplitude(std::move(factor), "function");
}

TEST(ShortestSwing, IsEndlessForWhatStaysRisesOrJumps) {
  EXPECT_EQ(swing(Amplitude()), forever);
  EXPECT_EQ(swing(ramp(1e-12)), forever);
  EXPECT_EQ(swing(step_at(3e-6)), forever);
  EXPECT_NEAR(swing(Amplitude({{0.0, 1.0}, {3e-6 - 1e-12, 1.0}, {3e-6, 0.0}})), 3e-6, 1e-12);
  EXPECT_EQ(swing(function([](double t) { return t < 3e-6 ? 0.0 : 1.0; })), forever);
  EXPECT_EQ(swing(function([](double t) { return t; })), forever);
}

TEST(ShortestSwing, OfAPulseIsItsLength) {
  for (const double start : {0.0, 3.3e-6})
    for (const double length : {1e-12, 0.1e-6, 0.5e-6, 5e-6})
      EXPECT_NEAR(swing(pulse(length, start)), length, 1e-6 * length + 1e-20) << start;
  // A load that acts at the start and then ends also counts.
  EXPECT_NEAR(swing(Amplitude({{0.0, 1.0}, {1e-12, 0.0}})), 0.5e-12, 1e-18);
  // Nothing oscillates after it.
  EXPECT_EQ(swing(pulse(1e-12, 3e-6), 4e-6), forever);
}

TEST(ShortestSwing, OfASpikeIsItsWidthAtHalfItsHeight) {
  const Amplitude alone({{1e-6, 0.0}, {1.05e-6, 1.0}, {1.1e-6, 0.0}});
  EXPECT_NEAR(swing(alone), 0.05e-6, 1e-15);
  const Amplitude on_a_slope(
      {{0.0, 0.0}, {10e-6, 1.0}, {10.02e-6, 3.0}, {10.04e-6, 1.0}, {30e-6, 0.0}});
  EXPECT_NEAR(swing(on_a_slope), 0.03e-6, 1e-15);
  const Amplitude dip({{0.0, 1.0}, {5e-6, 1.0}, {5.01e-6, 0.2}, {5.02e-6, 1.0}});
  EXPECT_NEAR(swing(dip), 0.01e-6, 1e-15);
  // A change of a hundredth is noise.
  EXPECT_GT(swing(Amplitude({{0.0, 0.0}, {5e-6, 1.0}, {5.01e-6, 0.99}, {5.02e-6, 1.0}})), 1e-6);
}

TEST(ShortestSwing, OfAFunctionIsFoundBetweenTheSteps) {
  for (const double period : {20e-9, 33e-9, 0.2e-6, 0.4e-6})
    EXPECT_NEAR(
        swing(function([=](double t) { return std::sin(2.0 * std::numbers::pi * t / period); })) /
            period,
        1.0 / 3.0, 0.2)
        << period;  // of the first rise, or half the period
  EXPECT_GT(swing(function([](double t) { return std::sin(2e6 * t); })), steps_a_swing * dt);
  const double spike =
      swing(function([](double t) { return t > 7.01e-6 && t < 7.03e-6 ? 1.0 : 0.0; }));
  EXPECT_NEAR(spike, 0.02e-6, 0.005e-6);
}

TEST(LoadRemarks, NameTheLoadTheTimeAndTheStep) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e9}, 0.0, pulse(1e-12, 0.0)});
  plate.loads.tractions.push_back({Edge::left, {1e6, 0.0}, 0.0, ramp(1e-6)});
  const Simulation simulation(plate, test::numerics());
  EXPECT_THAT(load_remarks(simulation, end),
              ElementsAre(testing::AllOf(HasSubstr("traction 1 comes and goes within 1 ps"),
                                         HasSubstr("give a step of"))));
}

TEST(LoadRemarks, AreSilentForOrdinaryLoads) {
  Plate plate = test::edge_crack(12e6);
  plate.loads.tractions[0].amplitude = ramp(5e-6);
  plate.loads.tractions[1].amplitude = pulse(3e-6, 1e-6);
  EXPECT_THAT(load_remarks(Simulation(plate, test::numerics()), end), IsEmpty());
}

Plate heated(double change, Amplitude amplitude = {}) {
  Plate plate = test::bare_plate(40, 20);
  plate.material.alphaT = 3.3e-6;
  plate.loads.thermal_loads.push_back({{}, ScalarField(change), std::move(amplitude)});
  return plate;
}

// s0 is 1.03e-3 here, which is 310 K.
TEST(ShockRemarks, TellOfColdThatBreaksBondsAtOnce) {
  const auto of = [](double change) {
    return shock_remarks(Simulation(heated(change), test::numerics()), {});
  };
  EXPECT_THAT(of(-1000.0), ElementsAre(HasSubstr("it stretches bonds by 0.0033 at once")));
  EXPECT_THAT(of(-100.0), IsEmpty());
  EXPECT_THAT(of(1000.0), IsEmpty());  // which compresses
  const Simulation cold(heated(-1000.0), test::numerics());
  EXPECT_THAT(shock_remarks(cold, cold.thermal_strain()), IsEmpty());
}

TEST(ShockRemarks, TellOfJumpsToCome) {
  const auto of = [](double change, const Amplitude& amplitude) {
    return at_once_remarks(Simulation(heated(change, amplitude), test::numerics()), end, true);
  };
  EXPECT_THAT(of(-1000.0, step_at(5e-6)), ElementsAre(HasSubstr("at once")));
  EXPECT_THAT(of(1000.0, Amplitude({{0.0, 0.0}, {8e-6, 1.0}, {8e-6, 0.0}})),
              ElementsAre(HasSubstr("at once")));
  EXPECT_THAT(of(-1000.0, ramp(5e-6)), IsEmpty());
  EXPECT_THAT(of(-1000.0, step_at(50e-6)), IsEmpty());  // later
}

std::vector<std::string> remarks_on_grip(Support::Kind kind, double value, Amplitude amplitude,
                                         bool fresh = true) {
  Plate plate = test::bare_plate(40, 20);
  Support grip{strip(plate, Edge::right, 1e-3), kind, {value, 0.0}};
  grip.amplitude = std::move(amplitude);
  plate.loads.supports.push_back(grip);
  return at_once_remarks(Simulation(plate, test::numerics()), end, fresh);
}

// s0 times the spacing is 0.76 um here.
TEST(AtOnceRemarks, TellOfGripsThatTearBondsInOneStep) {
  using Kind = Support::Kind;
  const auto displaced = [](double value, Amplitude amplitude) {
    return remarks_on_grip(Kind::displacement, value, std::move(amplitude));
  };
  for (const Amplitude& amplitude : {Amplitude(), step_at(5e-6), pulse(5e-6, 2e-6)}) {
    EXPECT_THAT(displaced(1e-6, amplitude), ElementsAre(HasSubstr("its work is not known")));
    EXPECT_THAT(displaced(0.1e-6, amplitude), IsEmpty());
  }
  EXPECT_THAT(displaced(20e-6, ramp(15e-6)), IsEmpty());
  EXPECT_THAT(displaced(-1e-6, {}), ElementsAre(HasSubstr("0.002, s0 is 0.001")));
  EXPECT_THAT(remarks_on_grip(Kind::velocity, 1.0, {}), IsEmpty());
  // Half a spacing of 1 mm times s0, at 100 m/s.
  const double s0 = Lattice(test::bare_plate(40, 20), test::numerics()).calibration.s0;
  EXPECT_THAT(
      remarks_on_grip(Kind::velocity, 100.0, {}),
      ElementsAre(HasSubstr("give a step of " + quantity(s0 * 0.5e-3 / 100.0, "s") + " or less")));
  // A load that has acted before does not act suddenly.
  EXPECT_THAT(remarks_on_grip(Kind::velocity, 100.0, {}, false), IsEmpty());
}

}  // namespace
}  // namespace hackle
