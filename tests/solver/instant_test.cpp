// SPDX-License-Identifier: MIT
#include "solver/instant.hpp"

#include <functional>
#include <vector>

#include <gmock/gmock.h>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// A plate that is pulled, without symmetry.
Simulation moving() {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.tractions.push_back({Edge::top, Vec2(1e6, 3e6)});
  return Simulation(plate, test::numerics(), {1});
}

// Sees the plate at given times, in s.
class Seer : public Observer {
 public:
  Seer(std::vector<double> times, std::function<void(const Simulation&)> look)
      : times_(std::move(times)), look_(std::move(look)) {}
  bool due(const Simulation& simulation) override {
    return next_ < times_.size() && simulation.time() >= times_[next_];
  }
  double moment(const Simulation&) override { return times_[next_]; }
  void observe(const Simulation& simulation) override {
    ++next_;
    look_(simulation);
  }

 private:
  std::vector<double> times_;
  std::function<void(const Simulation&)> look_;
  std::size_t next_ = 0;
};

// On the line between the steps, which are reached one by one.
TEST(Instant, DisplacementsLieBetweenThoseOfTheSteps) {
  Simulation stepped = moving(), run = moving();
  for (int k = 0; k < 36; ++k) stepped.step();
  const Vec2 before = stepped.displacement(7, 8);
  stepped.step();
  const Vec2 after = stepped.displacement(7, 8);
  run.run(36.3 * run.dt());
  EXPECT_DOUBLE_EQ(run.time(), 36.3 * run.dt());
  const Vec2 seen = run.view().displacement(7, 8);
  EXPECT_NEAR((seen - (0.7 * before + 0.3 * after)).norm(), 0.0, 1e-12 * after.norm());
  const Vec2 stored = run.lattice().grid.dx * run.view().state().u(7, 8);
  EXPECT_NEAR((stored + run.lattice().grid.dx * run.state().origin - seen).norm(), 0.0,
              1e-12 * after.norm());
}

// A free plate in flight moves on a line: between steps, place and velocity are exact.
TEST(Instant, IsExactInFlight) {
  Plate plate = test::bare_plate(20, 10);
  plate.initial_conditions.push_back({std::nullopt, {0.0, 0.0}, {3.0, -2.0}});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(10.4 * simulation.dt());
  const Vec2 moved = simulation.view().displacement(3, 4), v = simulation.view().velocity(3, 4);
  EXPECT_NEAR((moved - simulation.time() * Vec2(3.0, -2.0)).norm(), 0.0, 1e-9 * moved.norm());
  EXPECT_NEAR((v - Vec2(3.0, -2.0)).norm(), 0.0, 1e-9);
}

// The error of a velocity between steps falls with the square of the step, like that at steps.
TEST(Instant, VelocitiesAreOfSecondOrder) {
  const double until = 4.37e-6;
  const auto velocity_with = [&](double step) {
    Plate plate = test::bare_plate(20, 10);
    plate.loads.tractions.push_back({Edge::top, Vec2(1e6, 3e6), 0.0, ramp(4e-6)});
    Numerics numerics = test::numerics();
    numerics.step = step;
    Simulation simulation(plate, numerics, {1});
    simulation.run(until);
    EXPECT_DOUBLE_EQ(simulation.time(), until);
    return simulation.view().velocity(7, 8);
  };
  const double step = 0.9 * moving().dt();
  const Vec2 fine = velocity_with(step / 64.0);
  const double coarse = (velocity_with(step) - fine).norm();
  EXPECT_LT((velocity_with(step / 4.0) - fine).norm(), coarse / 8.0);
  EXPECT_LT(coarse, 0.02 * fine.norm());
}

TEST(Instant, ObserversSeeTheTimesThatTheyAskFor) {
  Simulation simulation = moving();
  const double dt = simulation.dt();
  std::vector<double> seen;
  std::vector<std::int64_t> steps;
  Seer seer({2.5 * dt, 4.0 * dt, 6.9 * dt}, [&](const Simulation& s) {
    seen.push_back(s.time() / dt);
    steps.push_back(s.state().step);
  });
  Observer* observers[] = {&seer};
  simulation.run(8.0 * dt, observers);
  EXPECT_THAT(seen, testing::ElementsAre(testing::DoubleEq(2.5), testing::DoubleEq(4.0),
                                         testing::DoubleEq(6.9)));
  EXPECT_THAT(steps, testing::ElementsAre(3, 4, 7));
}

// However often it is looked at, and wherever a run is cut.
TEST(Instant, LooksAndCutsLeaveTheBitsAlone) {
  Simulation plain = moving(), cut = moving();
  const double dt = plain.dt();
  plain.run(20.0 * dt);
  Seer seer({0.5 * dt, 1.5 * dt, 7.7 * dt}, [](const Simulation& s) {
    EXPECT_FALSE(s.view().velocities().empty());
    EXPECT_FALSE(s.view().state().bonds.empty());
  });
  Observer* observers[] = {&seer};
  cut.run(7.8 * dt, observers);
  cut.run(5.5 * dt);
  cut.run(6.7 * dt);
  EXPECT_EQ(cut.state().hash(), plain.state().hash());
}

// What stands still stands where it is, at any time.
TEST(Instant, APlateAtRestIsNotMovedBack) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.tractions.push_back({Edge::top, Vec2(0.0, 3e6)});
  plate.loads.tractions.push_back({Edge::bottom, Vec2(0.0, -3e6)});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(3.5 * simulation.dt());
  simulation.relax();
  const Vec2 at_rest = simulation.displacement(7, 8);
  simulation.run(0.0);
  EXPECT_EQ(simulation.displacement(7, 8), at_rest);
}

// Kinetic and strain energy and the work done belong to one time.
TEST(Instant, TheLedgerIsThatOfTheStep) {
  Simulation between = moving(), at_step = moving();
  between.run(36.3 * between.dt());
  at_step.run(37.0 * at_step.dt());
  EXPECT_EQ(energy(between).kinetic, energy(at_step).kinetic);
  EXPECT_EQ(energy(between).residual(), energy(at_step).residual());
}

}  // namespace
}  // namespace hackle
