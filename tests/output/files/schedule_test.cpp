// SPDX-License-Identifier: MIT
#include "output/files/schedule.hpp"

#include <vector>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Simulation small() {
  return Simulation(test::bare_plate(20, 10), test::numerics(), {1});
}

// Returns the steps at which an output with interval `every` sees the state.
std::vector<std::int64_t> served(double every, std::int64_t steps) {
  Simulation simulation = small();
  Schedule schedule("movie", every, simulation);
  std::vector<std::int64_t> list;
  for (;;) {
    if (schedule.reached(simulation)) {
      list.push_back(simulation.state().step);
      schedule.advance(simulation);
    }
    if (simulation.state().step == steps) return list;
    simulation.step();
  }
}

TEST(Schedule, EveryStepServesEveryStep) {
  EXPECT_THAT(served(small().dt(), 4), testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST(Schedule, IsReachedByTheNextStepAndNeverDrifts) {
  // Moments 0, 2.4, 4.8, 7.2, 9.6, 12 steps.
  EXPECT_THAT(served(2.4 * small().dt(), 12), testing::ElementsAre(0, 3, 5, 8, 10, 12));
}

TEST(Schedule, ShowsTheTimesThemselves) {
  Simulation simulation = small();
  const double dt = simulation.dt();
  Schedule schedule("movie", 2.4 * dt, simulation);
  schedule.advance(simulation);
  for (int k = 0; k < 3; ++k) simulation.step();
  EXPECT_DOUBLE_EQ(schedule.moment(simulation), 2.4 * dt);
  for (int k = 0; k < 3; ++k) simulation.step();  // it was not asked in time
  EXPECT_DOUBLE_EQ(schedule.moment(simulation), 6.0 * dt);
}

TEST(Schedule, LessThanAStepMeansEveryStepAndIsSaid) {
  EXPECT_THAT(served(0.3 * small().dt(), 4), testing::ElementsAre(0, 1, 2, 3, 4));
  const Simulation simulation = small();
  EXPECT_THAT(Schedule("movie", 0.3 * simulation.dt(), simulation).remark(),
              testing::AllOf(testing::HasSubstr("movie: every is "),
                             testing::HasSubstr("it takes every step")));
  EXPECT_EQ(Schedule("movie", simulation.dt(), simulation).remark(), "");
}

TEST(Schedule, StartsWhereTheSimulationIs) {
  Simulation simulation = small();
  simulation.step();
  simulation.step();
  const Schedule schedule("movie", 5.0 * simulation.dt(), simulation);
  EXPECT_TRUE(schedule.reached(simulation));
}

TEST(Schedule, GoesOnWhereAnotherOneWas) {
  Simulation simulation = small();
  const double dt = simulation.dt();
  simulation.step();
  Schedule former("movie", 2.4 * dt, simulation);
  for (int k = 0; k < 4; ++k, simulation.step())
    if (former.reached(simulation)) former.advance(simulation);
  Schedule schedule("movie", 2.4 * dt, simulation);
  schedule.go_on(former.start(), former.passed());
  EXPECT_DOUBLE_EQ(schedule.start(), dt);
  EXPECT_EQ(schedule.passed(), 2);
  EXPECT_EQ(schedule.next_due(simulation), former.next_due(simulation));
  for (int k = 0; k < 9; ++k, simulation.step()) {
    ASSERT_EQ(schedule.reached(simulation), former.reached(simulation)) << k;
    if (!former.reached(simulation)) continue;
    EXPECT_EQ(schedule.moment(simulation), former.moment(simulation));
    schedule.advance(simulation);
    former.advance(simulation);
  }
}

TEST(Schedule, RefusesNonsense) {
  const Simulation simulation = small();
  for (const double every : {0.0, -1.0, std::nan("")}) {
    try {
      const Schedule schedule("movie", every, simulation);
      FAIL() << every;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_THAT(error.what(), testing::HasSubstr("it must be above 0 s"));
    }
  }
}

// Its times count from the present time of the simulation when the output was added.
TEST(Schedule, CountsFromItsOwnStart) {
  Simulation simulation = small();
  simulation.step();
  simulation.step();
  Schedule schedule("movie", 5.0 * simulation.dt(), simulation);
  std::vector<std::int64_t> list;
  for (; simulation.state().step <= 12; simulation.step())
    if (schedule.reached(simulation)) {
      list.push_back(simulation.state().step);
      schedule.advance(simulation);
    }
  EXPECT_THAT(list, testing::ElementsAre(2, 7, 12));
}

// Quasi-static loading passes many times at once: the following steps do not make up for them.
TEST(Schedule, MomentsThatHavePassedAreNotMadeUpFor) {
  Simulation simulation = small();
  const double dt = simulation.dt();
  Schedule schedule("on", 2.0 * dt, simulation);
  schedule.advance(simulation);
  simulation.load_slowly({21.0 * dt, 1});
  EXPECT_TRUE(schedule.reached(simulation));
  schedule.advance(simulation);
  EXPECT_FALSE(schedule.reached(simulation));
  simulation.run(dt);
  EXPECT_TRUE(schedule.reached(simulation));
}

// Counts the times until a given time, including those that have passed.
TEST(Schedule, SaysHowManyMomentsThereAre) {
  Simulation simulation = small();
  simulation.step();
  simulation.step();
  const double dt = simulation.dt();
  Schedule schedule("movie", 5.0 * dt, simulation);
  EXPECT_EQ(schedule.moments(2.0 * dt, 100), 1);
  EXPECT_EQ(schedule.moments(6.9 * dt, 100), 1);
  EXPECT_EQ(schedule.moments(7.0 * dt, 100), 2);
  EXPECT_EQ(schedule.moments(22.0 * dt, 100), 5);
  EXPECT_EQ(schedule.moments(22.0 * dt, 3), 3);
  schedule.advance(simulation);
  EXPECT_EQ(schedule.moments(22.0 * dt, 100), 5);
  EXPECT_EQ(schedule.moments(22.0 * dt, 3), 4);  // one has passed, three more
  EXPECT_EQ(schedule.moments(0.0, 100), 1);
}

}  // namespace
}  // namespace hackle
