// SPDX-License-Identifier: MIT
#include "output/run/prospect.hpp"

#include <gmock/gmock.h>

#include "output/run/rehearsal.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using Verdict = Forecast::Verdict;

// 100 x 40 mm of Duran 50 with a crack of 50 mm: 3 MPa may break it slowly, 12 MPa do.
class ProspectTest : public testing::Test {
 protected:
  static Plate plate() {
    Plate plate = test::edge_crack(0.0);
    plate.loads = {};
    return plate;
  }
  static Loads pull(double stress, Amplitude amplitude = {}) {
    Loads loads;
    loads.tractions.push_back({Edge::top, {0.0, stress}, 0.0, std::move(amplitude)});
    return loads;
  }
  static Loads led(double velocity) {
    Loads loads;
    loads.supports.push_back({strip(plate(), Edge::top, 2e-3),
                              Support::Kind::velocity,
                              {0.0, velocity},
                              true,
                              true,
                              {}});
    return loads;
  }

  void exchange(Loads loads) {
    prospect_.exchange_loads(simulation_, loads);
    simulation_.set_loads(std::move(loads));
  }
  void pass(double time) {
    State state = simulation_.state();
    state.step = std::llround(time / simulation_.dt());
    simulation_.restore(std::move(state));
  }
  Verdict verdict() const { return prospect_.worst(simulation_).verdict(); }
  std::string text() const { return describe(rehearse(simulation_, prospect_)); }

  Simulation simulation_{plate(), test::numerics(4e-3, 16e-3), {1}};
  Prospect prospect_;
};

TEST_F(ProspectTest, OfNoLoadsIsThatNothingCanBreak) {
  prospect_.run(simulation_, 10e-6);
  EXPECT_EQ(verdict(), Verdict::nothing_loads_it);
  EXPECT_THAT(text(), testing::HasSubstr("nothing can break"));
}

TEST_F(ProspectTest, JudgesLoadsAsTheyWereWhileTheyActed) {
  exchange(pull(24e6));
  prospect_.run(simulation_, 30e-6);
  pass(30e-6);
  exchange({});
  prospect_.run(simulation_, 31e-6);
  EXPECT_EQ(verdict(), Verdict::breaks);
  EXPECT_EQ(prospect_.steps(), std::ceil(31e-6 / simulation_.dt()));
}

TEST_F(ProspectTest, LooksAtAmplitudesInTheTimeThatPasses) {
  exchange(pull(24e6, step_at(20e-6)));
  prospect_.run(simulation_, 10e-6);
  EXPECT_EQ(verdict(), Verdict::nothing_loads_it);
  pass(30e-6);
  prospect_.run(simulation_, 40e-6);
  EXPECT_EQ(verdict(), Verdict::breaks);
}

TEST_F(ProspectTest, KnowsSlowLoadingAndRest) {
  exchange(pull(24e6, ramp(100e-6)));
  prospect_.load_slowly(simulation_, 100e-6, 7);
  EXPECT_DOUBLE_EQ(prospect_.worst(simulation_).stress, 24e6);  // without waves
  EXPECT_EQ(verdict(), Verdict::breaks);
  EXPECT_THAT(text(), testing::HasSubstr("slow loading in 7 increments"));
  Prospect rest;
  pass(50e-6);
  rest.relax(simulation_);
  EXPECT_NEAR(rest.worst(simulation_).stress, 12e6, 0.1e6);
}

TEST_F(ProspectTest, WhatIsLetGoOfSwingsAsFarAsItWasHeld) {
  exchange(pull(6e6));
  prospect_.relax(simulation_);
  exchange({});
  prospect_.run(simulation_, 1e-6);
  EXPECT_DOUBLE_EQ(prospect_.worst(simulation_).stress, 6e6);
  EXPECT_NE(verdict(), Verdict::nothing_loads_it);
}

// A velocity acts at once by a wave of E v/c, and with time by the strain of its displacement.
TEST_F(ProspectTest, AVelocityActsAtOnceAsAWaveAndInTimeAsAStrain) {
  const double E = 65e9, impedance = std::sqrt(E * 2235.0);
  exchange(led(1.0));
  prospect_.run(simulation_, 1e-6);
  EXPECT_DOUBLE_EQ(prospect_.worst(simulation_).stress, 2.0 * impedance);
  pass(1e-6);
  prospect_.run(simulation_, 100e-6);
  EXPECT_NEAR(prospect_.worst(simulation_).stress, 2.0 * E * 100e-6 / 0.04, 1.0);
  Prospect slow;
  slow.load_slowly(simulation_, 2e-6, 1);
  EXPECT_NEAR(slow.worst(simulation_).stress, E * 2e-6 / 0.04, 1.0);
}

TEST_F(ProspectTest, KnowsHeatOfAnInclusionAlone) {
  Plate plate = ProspectTest::plate();
  plate.inclusions.push_back({rectangle({0.04, 0.01}, {0.06, 0.03}), plate.material});
  plate.inclusions.front().material.alphaT = 9e-6;
  plate.loads.thermal_loads.push_back({std::nullopt, 100.0, {}});
  const Simulation simulation(plate, test::numerics(4e-3, 16e-3), {1});
  Prospect prospect;
  prospect.relax(simulation);
  EXPECT_DOUBLE_EQ(prospect.worst(simulation).stress, 65e9 * 9e-6 * 100.0);
}

TEST_F(ProspectTest, WhatCannotBeJudgedIsSaidToBeUnknown) {
  prospect_.run(simulation_, 1e-6);
  prospect_.doubt("a function may change loads");
  EXPECT_THAT(text(), testing::HasSubstr("unknown: a function may change loads"));
  EXPECT_THAT(text(), testing::Not(testing::HasSubstr("nothing can break")));
  exchange(pull(1e6));
  prospect_.run(simulation_, 1e-6);
  EXPECT_THAT(text(),
              testing::HasSubstr("nothing should break\n           that is, of what is known"));
}

TEST_F(ProspectTest, WhatFollowsALookAtResultsIsUnknown) {
  prospect_.run(simulation_, 1e-6);
  prospect_.look();
  EXPECT_THAT(text(), testing::Not(testing::HasSubstr("unknown")));
  EXPECT_THAT(text(), testing::HasSubstr("unless the script does more when it sees results"));
  prospect_.run(simulation_, 2e-6);
  EXPECT_THAT(text(), testing::HasSubstr("looked at results"));
}

TEST_F(ProspectTest, AFunctionThatIsZeroWhereverItWasAskedIsNoReassurance) {
  exchange(pull(24e6, Amplitude([](double) { return 0.0; }, "function")));
  prospect_.run(simulation_, 1e-6);
  EXPECT_THAT(text(), testing::HasSubstr("unknown"));
  EXPECT_THAT(text(), testing::Not(testing::HasSubstr("nothing can break")));
}

}  // namespace
}  // namespace hackle
