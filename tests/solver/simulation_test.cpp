// SPDX-License-Identifier: MIT
#include "solver/simulation.hpp"

#include <limits>
#include <set>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "solver/default_step.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

Simulation small() {
  return Simulation(test::bare_plate(20, 10), test::numerics(), {1});
}

class Watcher : public Observer {
 public:
  bool due(const Simulation&) override { return true; }
  void observe(const Simulation& simulation) override {
    steps.push_back(simulation.state().step);
    if (interrupt_at == simulation.state().step) request_interrupt();
  }
  std::vector<std::int64_t> steps;
  std::int64_t interrupt_at = -1;
};

// Nine tenths of the limit are 209.1 ns, of which neither 1 us nor 10 us is a multiple.
TEST(Simulation, TheDefaultStepDividesRoundTimes) {
  EXPECT_EQ(default_step(0.0), 0.0);  // nothing divides, and nothing is searched for ever
  EXPECT_DOUBLE_EQ(default_step(232.38e-9), 200e-9);
  EXPECT_DOUBLE_EQ(default_step(1.15), 1.0);
  EXPECT_DOUBLE_EQ(default_step(0.36e-6), 10e-6 / 31.0);
}

// The power of ten of which the step is a part has at most 190 parts.
TEST(Simulation, TheDefaultStepLosesATwentiethAtMost) {
  for (double limit = 1e-9; limit < 1e-5; limit *= 1.0113) {
    const double longest = 0.9 * limit, step = default_step(limit);
    EXPECT_LE(step, longest * (1.0 + 1e-8)) << limit;
    EXPECT_GE(step, 0.95 * longest) << limit;
    double whole = std::pow(10.0, std::ceil(std::log10(step) - 1e-9));
    while (std::abs(std::round(whole / step) - whole / step) > 1e-6) whole *= 10.0;
    EXPECT_LE(whole / step, 190.0) << limit;
  }
}

TEST(Simulation, TakesTheShareOfTheLimitThatItsUserSays) {
  const double limit = small().lattice().step_limit;
  for (const double safety : {1.0, 0.5, 0.03}) {
    Numerics numerics = test::numerics();
    numerics.safety = safety;
    const double dt = Simulation(test::bare_plate(20, 10), numerics).dt();
    EXPECT_LE(dt, safety * limit);
    EXPECT_GE(dt, 0.95 * safety * limit);
  }
}

TEST(Simulation, RunsToTheFirstStepAtOrAfterTheTimeAskedFor) {
  Simulation simulation = small();
  simulation.run(10.0 * simulation.dt());
  EXPECT_EQ(simulation.state().step, 10);
  simulation.run(0.5 * simulation.dt());
  EXPECT_EQ(simulation.state().step, 11);
  simulation.run(0.5 * simulation.dt());
  EXPECT_EQ(simulation.state().step, 11);
}

TEST(Simulation, ShowsTheStartAndEveryStepToObservers) {
  Simulation simulation = small();
  Watcher watcher;
  Observer* observers[] = {&watcher};
  simulation.run(3.0 * simulation.dt(), observers);
  EXPECT_THAT(watcher.steps, testing::ElementsAre(0, 1, 2, 3));
}

// Sees every fourth step, and counts how often it is asked.
class Sparse : public Observer {
 public:
  std::int64_t next_due(const Simulation&) override { return next; }
  bool due(const Simulation& simulation) override {
    ++asked;
    return simulation.state().step >= next;
  }
  void observe(const Simulation& simulation) override {
    steps.push_back(simulation.state().step);
    next = simulation.state().step + 4;
  }
  std::vector<std::int64_t> steps;
  std::int64_t next = 0;
  int asked = 0;
};

TEST(Simulation, AsksAnObserverNoEarlierThanItSays) {
  Simulation simulation = small();
  Sparse sparse;
  Observer* observers[] = {&sparse};
  simulation.run(10.0 * simulation.dt(), observers);
  EXPECT_THAT(sparse.steps, testing::ElementsAre(0, 4, 8));
  EXPECT_EQ(sparse.asked, 3);
}

TEST(Simulation, StopsAfterTheStepWhenInterruptedAndCanGoOn) {
  Simulation simulation = small();
  Watcher watcher;
  watcher.interrupt_at = 5;
  Observer* observers[] = {&watcher};
  try {
    simulation.run(20.0 * simulation.dt(), observers);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
  clear_interrupt();
  EXPECT_EQ(simulation.state().step, 5);
  simulation.run(2.0 * simulation.dt());
  EXPECT_EQ(simulation.state().step, 7);
}

TEST(Simulation, RefusesAnImpossibleDuration) {
  Simulation simulation = small();
  for (const double bad :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(simulation.run(bad), Error) << bad;
}

TEST(Simulation, RefusesABadSceneWithEveryProblem) {
  Plate plate = test::bare_plate(20, 10);
  plate.width = -1.0;
  plate.material.E = 0.0;
  try {
    const Simulation simulation(plate, test::numerics());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_GE(error.problems().size(), 2U);
  }
}

TEST(Simulation, APlateAtRestStaysAtRest) {
  Simulation simulation = small();
  simulation.run(5e-6);
  EXPECT_EQ(test::largest(simulation.velocities()), 0.0);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(simulation.displacement(i, 5), Vec2(0, 0));
  EXPECT_EQ(simulation.ledger().external, 0.0);
}

// Wider than the blocks of columns that tasks work on: a bond in the margin of two is lost once.
TEST(Simulation, EveryBondThatBreaksIsLostOnce) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(test::bare_plate(2100, 12), numerics, {2});
    simulation.restore(test::displaced(simulation, [](const Vec2& x) { return Vec2(0.1 * x); }));
    const std::int64_t before = simulation.state().bonds.count();
    simulation.step();
    std::set<std::tuple<std::ptrdiff_t, int, std::uint32_t>> lost;
    for (const BrokenBond& loss : simulation.broken_bonds())
      lost.emplace(loss.at, loss.word, loss.bit);
    EXPECT_GT(lost.size(), 1000U);
    EXPECT_EQ(lost.size(), simulation.broken_bonds().size());
    EXPECT_EQ(before - simulation.state().bonds.count(), std::ssize(lost));
  }
}

}  // namespace
}  // namespace hackle
