// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "solver/tabulated_course.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Execution threads(int count) {
  return {.threads = count};
}

Support moved(const Shape& region, Support::Kind kind, const Vec2& value,
              Amplitude amplitude = {}) {
  Support support;
  support.region = region;
  support.kind = kind;
  support.value = value;
  support.amplitude = std::move(amplitude);
  return support;
}

// A body force on a whole free plate accelerates it as a point mass: u'' = a f(t).
TEST(Loading, FollowsItsAmplitudeInTime) {
  const double force = 1e9, rho = 2235.0;
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = test::bare_plate(20, 10);
    plate.loads.body_forces.push_back({{}, {force, 0.0}, ramp(4e-6)});
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, threads(1));
    simulation.run(3e-6);
    const double t = simulation.time(), exact = force / rho * t * t * t / (6.0 * 4e-6);
    // Leapfrog sums t^3/6 with the relative error (dt/t)^2.
    const double error = std::pow(simulation.dt() / t, 2);
    const double rounding = precision == Precision::f64 ? 1e-12 : 1e-5;
    EXPECT_NEAR(simulation.displacement(7, 3).x(), exact, (error + rounding) * exact);
  }
}

TEST(Loading, GivesTheBitsOfConstantLoadsWhenTheFactorIsOne) {
  Plate constant = test::edge_crack(12e6), varied = constant;
  for (Traction& traction : varied.loads.tractions)
    traction.amplitude = Amplitude([](double) { return 1.0; }, "one");
  Simulation one(constant, test::numerics()), other(varied, test::numerics());
  one.run(8e-6);
  other.run(8e-6);
  // Their work is added up in halves.
  State state = other.state();
  EXPECT_NEAR(state.external_work, one.state().external_work,
              1e-12 * std::abs(state.external_work));
  state.external_work = one.state().external_work;
  EXPECT_EQ(one.state().hash(), state.hash());
}

TEST(Loading, TheLedgerOfARampIsOfSecondOrderInTheStep) {
  const auto leak = [](double dt) {
    Plate plate = test::edge_crack(12e6);
    for (Traction& traction : plate.loads.tractions) traction.amplitude = ramp(5e-6);
    Numerics numerics = test::numerics();
    numerics.step = dt;
    Simulation simulation(plate, numerics);
    simulation.run(4.8e-6);
    return std::abs(energy(simulation).residual()) / energy(simulation).external;
  };
  const double coarse = leak(160e-9), fine = leak(80e-9);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(coarse / fine, 3.0);
}

TEST(Loading, RefusesARunTooLongToCountOrToTabulate) {
  Plate plate = test::bare_plate(20, 10);
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_THROW(simulation.run(1e300), Error);
  EXPECT_THROW(simulation.run(1e9), Error);
  plate.loads.body_forces.push_back({{}, {1.0, 0.0}, Amplitude([](double) { return 1.0; }, "one")});
  Simulation loaded(plate, test::numerics(), {1});
  EXPECT_THROW(loaded.run(100.0), Error);
  for (const Simulation* one : {&simulation, &loaded}) EXPECT_EQ(one->state().step, 0);
  simulation.run(1e-6);  // the time asked for in vain is forgotten
  EXPECT_NEAR(simulation.time(), 1e-6, simulation.dt());
}

TEST(Loading, AsksAFunctionBeforeTheRunOnly) {
  int calls = 0;
  bool running = false;
  Plate plate = test::bare_plate(20, 10);
  const auto factor = [&](double t) {
    EXPECT_FALSE(running);
    ++calls;
    return 1e6 * t;
  };
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e6}, 0.0, Amplitude(factor, "line")});
  Simulation simulation(plate, test::numerics(), threads(1));
  struct Watch : Observer {
    explicit Watch(bool& r) : mark(r) {}
    bool due(const Simulation&) override { return mark = true; }
    void observe(const Simulation&) override {}
    bool& mark;
  } watch(running);
  Observer* const observers[] = {&watch};
  simulation.run(10 * simulation.dt(), observers);
  EXPECT_GE(calls, 10);
}

VectorField field_in_time(std::function<Vec2(const Vec2&, double)> function) {
  return VectorField(std::move(function));
}

// f(x) g(t) as a function of place and time is f(x) with the amplitude g, to the tolerance of its
// table: linear response.
TEST(Loading, AFunctionOfPlaceAndTimeIsOneOfPlaceWithAnAmplitude) {
  const auto place = [](const Vec2& at) { return Vec2(1e6, 3e8 * at.x()); };
  const auto time = [](double t) { return std::sin(1.5e6 * t); };
  Plate apart = test::bare_plate(20, 10), together = apart;
  apart.loads.tractions.push_back(
      {Edge::top, VectorField(std::function<Vec2(const Vec2&)>(place)), 0.0, Amplitude(time, "")});
  together.loads.tractions.push_back(
      {Edge::top,
       field_in_time([=](const Vec2& at, double t) { return Vec2(time(t) * place(at)); }),
       0.0,
       {}});
  Simulation one(apart, test::numerics(), threads(1)),
      other(together, test::numerics(), threads(1));
  double largest = 0.0, error = 0.0;
  for (int part = 0; part < 5; ++part) {
    one.run(2e-6);
    other.run(2e-6);
    const Vec2 u = one.displacement(13, 4);
    largest = std::max(largest, u.norm());
    error = std::max(error, (other.displacement(13, 4) - u).norm());
  }
  EXPECT_GT(error, 0.0);  // it is a table
  EXPECT_LT(error, TabulatedCourse<Vec2>::max_error * largest);
  const auto wanted = energy(one), found = energy(other);
  EXPECT_NEAR(found.external, wanted.external, 1e-3 * (wanted.kinetic + wanted.strain));
  EXPECT_NEAR(found.residual(), wanted.residual(), 1e-3 * (wanted.kinetic + wanted.strain));
}

TEST(Loading, AFunctionOfPlaceAndTimeDoesNotNoticeHowARunIsCut) {
  Plate plate = test::bare_plate(20, 10);
  const auto travels = [](const Vec2& at, double t) {
    return Vec2(1e6 * std::exp(-std::pow((at.x() - 3e3 * t) / 1e-3, 2)), 0.0);
  };
  plate.loads.body_forces.push_back({{}, field_in_time(travels), ramp(3e-6)});
  Support pulled = moved(strip(plate, Edge::left, 1e-3), Support::Kind::velocity, {0, 0});
  pulled.value =
      field_in_time([](const Vec2& at, double t) { return Vec2(1e5 * t, 50.0 * at.y()); });
  plate.loads.supports.push_back(pulled);
  Simulation whole(plate, test::numerics(), threads(1)), cut(plate, test::numerics(), threads(1));
  const double dt = whole.dt();
  whole.run(150 * dt);
  for (const int steps : {1, 30, 40, 79}) cut.run(steps * dt);
  EXPECT_EQ(cut.state().step, whole.state().step);
  EXPECT_EQ(cut.state().hash(), whole.state().hash());
}

TEST(Loading, AFunctionOfPlaceAndTimeThatFailsLeavesTheRunWhereItWas) {
  Plate plate = test::bare_plate(20, 10);
  const auto fails = [](const Vec2&, double t) { return Vec2(t < 2e-6 ? 1e6 : std::nan(""), 0.0); };
  plate.loads.tractions.push_back({Edge::top, field_in_time(fails), 0.0, {}});
  Simulation simulation(plate, test::numerics(), threads(1));
  EXPECT_THROW(simulation.run(50e-6), Error);
  EXPECT_EQ(simulation.state().step, 0);
}

// A bar that is pulled at rest by a function of time is stretched by its value now.
TEST(Loading, AFunctionOfPlaceAndTimeActsAtRestAsItIsNow) {
  const auto middle = [](Plate plate, VectorField stress) {
    plate.loads.tractions.push_back({Edge::right, std::move(stress), 0.0, {}});
    plate.loads.supports.push_back(
        moved(strip(plate, Edge::left, 1e-3), Support::Kind::displacement, {0, 0}));
    Simulation simulation(plate, test::numerics(), threads(1));
    simulation.load_slowly({4e-6, 2});
    return simulation.displacement(15, 5).x();
  };
  const Plate plate = test::bare_plate(20, 10);
  const double wanted = middle(plate, Vec2(4e5, 0.0));
  EXPECT_NEAR(
      middle(plate, field_in_time([](const Vec2&, double t) { return Vec2(1e11 * t, 0.0); })),
      wanted, 1e-6 * wanted);
}

TEST(Loading, AFunctionThatFailsLeavesTheRunWhereItWas) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.tractions.push_back(
      {Edge::top,
       {0.0, 1e6},
       0.0,
       Amplitude([](double t) { return t < 2e-6 ? 1.0 : NAN; }, "bad")});
  Simulation simulation(plate, test::numerics());
  simulation.run(1e-6);
  const std::string before = simulation.state().hash();
  EXPECT_THROW(simulation.run(5e-6), Error);
  EXPECT_EQ(simulation.state().hash(), before);
  EXPECT_LT(simulation.end_time(), 1.3e-6);
  simulation.run(0.5e-6);  // up to there it goes on
}

TEST(Supports, HoldNodesWhereTheyAreAndFreeTheOtherAxis) {
  Plate plate = test::edge_crack(12e6);
  Support clamp = moved(strip(plate, Edge::right, 2e-3), Support::Kind::displacement, {0, 0});
  clamp.along_y = false;
  plate.loads.supports.push_back(clamp);
  Simulation simulation(plate, test::numerics());
  simulation.run(10e-6);
  double max_y = 0.0;
  for (int j = 0; j < 80; ++j)
    for (int i = 196; i < 200; ++i) {
      EXPECT_EQ(simulation.displacement(i, j).x(), 0.0);
      max_y = std::max(max_y, std::abs(simulation.displacement(i, j).y()));
    }
  EXPECT_GT(max_y, 1e-7);
}

TEST(Supports, LeadNodesToTheirDisplacementAndAtTheirVelocity) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = test::bare_plate(40, 20);
    const auto end = [&](Edge edge) { return strip(plate, edge, 1e-3); };
    plate.loads.supports = {
        moved(end(Edge::left), Support::Kind::displacement, {-2e-6, 1e-6}, ramp(2e-6)),
        moved(end(Edge::right), Support::Kind::velocity, {1.0, 0.0})};
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics);
    simulation.run(3e-6);
    const double slack = precision == Precision::f64 ? 1e-18 : 1e-11;
    EXPECT_NEAR(simulation.displacement(0, 5).x(), -2e-6, slack);
    EXPECT_NEAR(simulation.displacement(1, 5).y(), 1e-6, slack);
    EXPECT_NEAR(simulation.displacement(39, 5).x(), simulation.time(), 3 * slack);
  }
}

// What supports put in is found again: a plate pulled apart at both ends.
TEST(Supports, DoTheWorkThatThePlateReceives) {
  Plate plate = test::bare_plate(80, 40);
  plate.loads.supports = {
      moved(strip(plate, Edge::left, 1e-3), Support::Kind::velocity, {-2.0, 0.0}, ramp(1e-6)),
      moved(strip(plate, Edge::right, 1e-3), Support::Kind::velocity, {2.0, 0.0}, ramp(1e-6))};
  Simulation simulation(plate, test::numerics());
  simulation.run(8e-6);
  const Energy ledger = energy(simulation);
  EXPECT_GT(ledger.external, 0.0);
  // Of the order of (omega dt)^2 of the waves made: those of 1 us.
  EXPECT_NEAR(ledger.residual(), 0.0, 5e-3 * ledger.external);
}

TEST(Loads, MayBeChangedBetweenRuns) {
  Plate plate = test::bare_plate(40, 20);
  Simulation simulation(plate, test::numerics());
  simulation.run(1e-6);
  EXPECT_EQ(simulation.displacement(20, 19).norm(), 0.0);
  Loads loads;
  loads.tractions.push_back({Edge::top, {0.0, 5e6}});
  simulation.set_loads(loads);
  simulation.run(1e-6);
  EXPECT_GT(simulation.displacement(20, 19).y(), 0.0);
  loads.tractions.front().stress = Vec2(NAN, 0.0);
  const std::string before = simulation.state().hash();
  EXPECT_THROW(simulation.set_loads(loads), Error);
  EXPECT_EQ(simulation.state().hash(), before);
  EXPECT_EQ(simulation.plate().loads.tractions.front().stress.constant().y(), 5e6);
}

TEST(InitialCondition, SetsThePlateInMotionAndItsEnergyIsAccountedFor) {
  Plate plate = test::bare_plate(40, 20);
  plate.initial_conditions.push_back({{}, Vec2(0.0, 0.0), Vec2(3.0, -1.0)});
  plate.initial_conditions.push_back(
      {rectangle({0, 0}, {5e-3, 10e-3}), Vec2(1e-7, 0.0), Vec2(0.0, 0.0)});
  Simulation simulation(plate, test::numerics());
  const Energy at_start = energy(simulation);
  const double mass = 2235.0 * 0.02 * 0.01;
  EXPECT_NEAR(at_start.kinetic, 0.5 * mass * 10.0, 1e-9);
  EXPECT_GT(at_start.strain, 0.0);
  EXPECT_NEAR(at_start.residual(), 0.0, 1e-12 * at_start.external);
  simulation.run(5e-6);
  EXPECT_NEAR(energy(simulation).residual(), 0.0, 1e-3 * at_start.external);
}

TEST(Damping, TakesTheMotionOfAPlateAsTheExponentialSays) {
  const double rate = 2e5;
  for (const int count : {1, 3}) {
    Plate plate = test::bare_plate(40, 20);
    plate.loads.damping = rate;
    plate.initial_conditions.push_back({{}, Vec2(0.0, 0.0), Vec2(2.0, 0.0)});
    Simulation simulation(plate, test::numerics(), threads(count));
    simulation.run(10e-6);
    const double factor = std::exp(-rate * simulation.time());
    EXPECT_NEAR(simulation.velocities().front().x(), 2.0 * factor, 1e-12);
    const Energy ledger = energy(simulation);
    EXPECT_NEAR(ledger.damped, ledger.external * (1.0 - factor * factor), 1e-9 * ledger.external);
    EXPECT_NEAR(ledger.residual(), 0.0, 1e-9 * ledger.external);
  }
}

TEST(Loading, GivesTheSameBitsForAnyNumberOfThreadsAndCuts) {
  Plate plate = test::edge_crack(12e6);
  plate.loads.damping = 1e4;
  plate.loads.tractions[0].amplitude = ramp(3e-6);
  plate.loads.supports.push_back(moved(strip(plate, Edge::right, 1e-3), Support::Kind::velocity,
                                       {1.0, 0.0}, pulse(2e-6, 1e-6)));
  Simulation one(plate, test::numerics(), threads(1)), other(plate, test::numerics(), threads(4));
  one.run(9e-6);
  for (int part = 0; part < 9; ++part) other.run(1e-6);
  EXPECT_EQ(one.state().step, other.state().step);
  EXPECT_EQ(one.state().hash(), other.state().hash());
}

}  // namespace
}  // namespace hackle
