// SPDX-License-Identifier: MIT
// The ledger of energy when what acts is changed on the way, by anybody: what is left over falls
// with the square of the step, and the work is that of an independent sum.
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "solver/terms/damping.hpp"
#include "support/composite.hpp"
#include "support/reference.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr double moment = 1.6e-6;  // s, of the change

struct Change {
  const char* name;
  std::function<void(Loads&, const Plate&)> make;
};

Support support(const Shape& region, Support::Kind kind, const Vec2& value) {
  Support support;
  support.region = region;
  support.kind = kind;
  support.value = value;
  return support;
}

const std::vector<Change>& changes() {
  static const std::vector<Change> list{
      {"traction", [](Loads& loads, const Plate&) { loads.tractions[0].stress = Vec2(4e6, 0.0); }},
      {"no traction", [](Loads& loads, const Plate&) { loads.tractions.clear(); }},
      {"two tractions",
       [](Loads& loads, const Plate&) {
         loads.tractions.push_back({Edge::left, {3e6, -1e6}});
         loads.tractions.push_back({Edge::left, {1e6, 2e6}, 1e-3});
       }},
      {"pressure",
       [](Loads& loads, const Plate&) {
         loads.pressures.push_back({"bore", 8e6, {}});
       }},
      {"body force",
       [](Loads& loads, const Plate&) {
         loads.body_forces.push_back({{}, Vec2(2e9, -1e9), {}});
       }},
      {"varying",
       [](Loads& loads, const Plate&) {
         loads.tractions[0].amplitude = Amplitude({{0.0, 0.5}, {3e-6, -1.0}});
       }},
      {"clamp",
       [](Loads& loads, const Plate& plate) {
         loads.supports.push_back(
             support(strip(plate, Edge::left, 1e-3), Support::Kind::velocity, {0.0, 0.0}));
       }},
      {"released", [](Loads& loads, const Plate&) { loads.supports.clear(); }},
      {"one of two released",
       [](Loads& loads, const Plate&) { loads.supports.erase(loads.supports.begin()); }},
      {"moved faster",
       [](Loads& loads, const Plate&) { loads.supports.back().value = Vec2(-1.5, 1.0); }},
      {"moved along x alone",
       [](Loads& loads, const Plate&) { loads.supports.back().along_y = false; }},
      {"damping", [](Loads& loads, const Plate&) { loads.damping = 4e5; }},
      {"no damping", [](Loads& loads, const Plate&) { loads.damping = 0.0; }},
      {"temperature",
       [](Loads& loads, const Plate& plate) {
         loads.thermal_loads.push_back(
             {rectangle({0, 0}, {0.5 * plate.width, plate.height}), ScalarField(20.0), {}});
       }},
      {"no temperature", [](Loads& loads, const Plate&) { loads.thermal_loads.clear(); }},
      {"changing temperature",
       [](Loads& loads, const Plate&) {
         loads.thermal_loads.push_back(
             {{}, ScalarField(-25.0), Amplitude({{1e-6, 1.0}, {3e-6, 0.0}})});
       }},
      {"impactor",
       [](Loads& loads, const Plate& plate) {
         loads.impactors.push_back({{-1.02e-3, 0.5 * plate.height}, 1e-3, {20.0, 0.0}, 0.05});
       }},
  };
  return list;
}

// Pulled on top, warm in part, held below by a support that stands and one that moves; elastic.
Plate busy_plate(bool mixed, double damping, double heat) {
  Plate plate = test::composite(24, 16, {.mixed = mixed});
  if (!mixed) plate.cutouts.push_back({test::disc({9e-3, 4e-3}, 0.9e-3), "bore"});
  plate.no_fail.push_back(strip(plate, Edge::top, plate.height));
  plate.loads.tractions.push_back({Edge::top, {1e6, 6e6}});
  plate.loads.supports = {
      support(rectangle({0, 0}, {3e-3, 1e-3}), Support::Kind::displacement, {0.0, 0.0}),
      support(rectangle({8e-3, 0}, {12e-3, 1e-3}), Support::Kind::velocity, {0.5, -1.0})};
  plate.loads.damping = damping;
  if (heat != 0.0)
    plate.loads.thermal_loads.push_back(
        {rectangle({6e-3, 0}, {12e-3, 8e-3}), ScalarField(heat), {}});
  return plate;
}

Numerics with_step(double dt) {
  Numerics numerics = test::numerics();
  numerics.step = dt;
  return numerics;
}

void apply(const Change& change, Simulation& simulation) {
  Loads loads = simulation.plate().loads;
  change.make(loads, simulation.plate());
  simulation.set_loads(std::move(loads));
}

// Root of the mean square of the residual at 16 moments after the change, that of the change itself
// among them, over what was put in.
double leak(const Change& change, const Plate& plate, double dt) {
  Simulation simulation(plate, with_step(dt), {1});
  simulation.run(moment);
  apply(change, simulation);
  double sum = 0.0, max = 0.0;
  for (int k = 0; k < 16; ++k) {
    const Energy now = energy(simulation);
    sum += now.residual() * now.residual();
    max = std::max(max, std::abs(now.external));
    simulation.run(0.1e-6);
  }
  return std::sqrt(sum / 16.0) / max;
}

class Ledger : public testing::TestWithParam<std::size_t> {};

// Halving the step leaves a quarter; what is left of the fourth order shows in the margin.
TEST_P(Ledger, ClosesToTheSecondOrderOverAChange) {
  const Change& change = changes()[GetParam()];
  for (const bool mixed : {false, true})
    for (const double damping : {0.0, 2e5})
      for (const double heat : {0.0, 30.0}) {
        const Plate plate = busy_plate(mixed, damping, heat);
        const double coarse = leak(change, plate, 25e-9), fine = leak(change, plate, 12.5e-9);
        EXPECT_GT(coarse / fine, 3.3)
            << change.name << (mixed ? " mixed" : "") << " damping " << damping << " heat " << heat
            << ": " << coarse << " and " << fine;
        EXPECT_LT(coarse, 0.02) << change.name;
      }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, Ledger, testing::Range(std::size_t{0}, std::size_t{17}));

TEST(LedgerOfChanges, KnowsAllKinds) {
  EXPECT_EQ(changes().size(), 17U);
}

// 1/2 (b_n + b_n+1) . (u_n+1 - u_n) over all nodes and steps, b what the loads are from a step on.
class WorkOfForces {
 public:
  explicit WorkOfForces(const Simulation& simulation) : u_(displacements(simulation)) {
    take(simulation);
  }

  void step(Simulation& simulation, const Change* change) {
    simulation.step();
    if (change != nullptr) apply(*change, simulation);
    const std::vector<Vec2> u = displacements(simulation);
    const std::vector<Vec2> before = forces_;
    take(simulation);
    for (std::size_t node = 0; node < u.size(); ++node)
      work_ += 0.5 * (before[node] + forces_[node]).dot(u[node] - u_[node]);
    u_ = u;
  }

  double work() const { return work_; }  // J/m

 private:
  static std::vector<Vec2> displacements(const Simulation& simulation) {
    std::vector<Vec2> u;
    for (int j = 0; j < simulation.lattice().grid.ny; ++j)
      for (int i = 0; i < simulation.lattice().grid.nx; ++i)
        u.push_back(simulation.displacement(i, j));
    return u;
  }
  void take(const Simulation& simulation) {
    const Lattice& lattice = simulation.lattice();
    forces_.assign(lattice.grid.nodes(), Vec2(0, 0));
    for (const LoadedNode& load : simulation.actions().forces)
      forces_[lattice.grid.index(load.i, load.j)] +=
          lattice.material_at(load.i, load.j).material.rho * lattice.grid.dx * lattice.grid.dx *
          load.acceleration;
  }

  std::vector<Vec2> u_, forces_;
  double work_ = 0.0;
};

TEST(LedgerOfChanges, WorkOfForcesIsThatOfASumOverNodes) {
  for (const Change& change : changes())
    for (const bool mixed : {false, true}) {
      const std::string name = change.name;
      if (name.find("temperature") != std::string::npos || name.find("move") == 0 ||
          name.find("release") != std::string::npos || name == "clamp" || name == "impactor")
        continue;
      Plate plate = busy_plate(mixed, 1e5, 0.0);
      plate.loads.supports.clear();
      Simulation simulation(plate, with_step(80e-9), {1});
      WorkOfForces sum(simulation);
      for (int n = 1; n <= 20; ++n) sum.step(simulation, n % 7 == 0 ? &change : nullptr);
      EXPECT_NEAR(simulation.ledger().external, sum.work(), 1e-12 * std::abs(sum.work()) + 1e-18)
          << change.name << mixed;
    }
}

// The same for reactions: what it takes beside bonds and loads to move held nodes as they move,
// from forces of bonds that are computed apart.
TEST(LedgerOfChanges, WorkOfSupportsIsThatOfTheirReactions) {
  for (const bool mixed : {false, true}) {
    Plate plate = busy_plate(mixed, 0.0, 0.0);
    plate.loads.tractions.clear();
    plate.loads.supports.push_back(
        support(strip(plate, Edge::top, 1e-3), Support::Kind::velocity, {0.4, 2.0}));
    plate.loads.supports.back().amplitude = Amplitude({{0.0, 0.0}, {0.8e-6, 1.0}, {2e-6, 1.0}});
    Simulation simulation(plate, with_step(80e-9), {1});
    const Lattice& lattice = simulation.lattice();
    const auto mass = [&](const PrescribedNode& node) {
      return lattice.material_at(node.i, node.j).material.rho * lattice.grid.dx * lattice.grid.dx;
    };
    const double unit = std::pow(lattice.grid.dx / simulation.dt(), 2);
    double done = 0.0;
    for (int n = 0; n < 24; ++n) {
      const auto a = test::Reference(simulation).accelerations();
      const std::vector<PrescribedNode> prescribed = simulation.actions().prescribed;
      std::vector<Vec2> before;
      double ahead = 0.0;
      for (const PrescribedNode& node : prescribed) {
        before.push_back(simulation.state().v(node.i, node.j));
        if (n > 0)
          ahead -= 0.5 * mass(node) * unit *
                   a[lattice.grid.index(node.i, node.j)].cast<double>().dot(before.back());
      }
      EXPECT_NEAR(simulation.ledger().external, done + ahead, 1e-9 * std::abs(done) + 1e-15) << n;
      simulation.step();
      for (std::size_t k = 0; k < prescribed.size(); ++k) {
        const PrescribedNode& node = prescribed[k];
        const Vec2 v = simulation.state().v(node.i, node.j);
        const Vec2 bonds = a[lattice.grid.index(node.i, node.j)].cast<double>();
        // At the start there is no half step before.
        const Vec2 push = v - before[k] - bonds;
        done +=
            0.5 * mass(node) * unit *
            (n == 0 ? (v - before[k]).dot(v + before[k]) - bonds.dot(v) : push.dot(v + before[k]));
      }
    }
    EXPECT_GT(std::abs(done), 0.0);
  }
}

// The reproduction of a user: a load taken away by hand or by its amplitude.
TEST(LedgerOfChanges, ACallAndAnAmplitudeDoTheSame) {
  const auto external = [](bool call) {
    Plate plate = test::bare_plate(40, 40);
    plate.no_fail.push_back(strip(plate, Edge::top, plate.height));
    plate.loads.supports.push_back(
        support(strip(plate, Edge::bottom, 2e-3), Support::Kind::displacement, {0.0, 0.0}));
    plate.loads.tractions.push_back({Edge::top, {0.0, 6e6}});
    if (!call)
      plate.loads.tractions[0].amplitude =
          Amplitude({{0.0, 1.0}, {3e-6 - 1e-12, 1.0}, {3e-6, 0.0}});
    Simulation simulation(plate, with_step(20e-9));
    simulation.run(3e-6);
    if (call) {
      Loads loads = plate.loads;
      loads.tractions[0].stress = Vec2(0.0, 0.0);
      simulation.set_loads(loads);
    }
    simulation.run(3e-6);
    return simulation.ledger().external;
  };
  const double amplitude = external(false);
  EXPECT_NEAR(external(true), amplitude, 1e-12 * amplitude);
}

TEST(LedgerOfChanges, WhatChangesNothingLeavesTheBits) {
  Simulation simulation(busy_plate(true, 2e5, 30.0), with_step(80e-9));
  simulation.run(1e-6);
  const std::string before = simulation.state().hash();
  simulation.set_loads(simulation.plate().loads);
  EXPECT_EQ(simulation.state().hash(), before);
}

TEST(LedgerOfChanges, IsTheSameForACutRun) {
  const auto hash = [](int pieces) {
    Simulation simulation(busy_plate(true, 2e5, 30.0), with_step(80e-9));
    for (int k = 0; k < pieces; ++k) simulation.run(1.2e-6 / pieces);
    apply(changes()[0], simulation);
    for (int k = 0; k < pieces; ++k) simulation.run(1.2e-6 / pieces);
    return simulation.state().hash() + std::to_string(energy(simulation).residual());
  };
  EXPECT_EQ(hash(1), hash(3));
}

// A plate that creeps: whatever the rate, at the velocity a/rate, and the ledger closes.
TEST(Damping, LetsALoadedPlateCreepAtTheRightVelocity) {
  for (const double rate : {1e5, 3e6, 1e8}) {
    Plate plate = test::bare_plate(20, 10);
    plate.loads.damping = rate;
    plate.loads.body_forces.push_back({{}, Vec2(1e9, 0.0), {}});
    Simulation simulation(plate, test::numerics(), {1});
    simulation.run(20.0 / rate + 20 * simulation.dt());
    const double v = 1e9 / 2235.0 / rate;
    EXPECT_NEAR(simulation.velocities().front().x() / v, 1.0, 1e-6) << rate;
    const Energy now = energy(simulation);
    EXPECT_NEAR(now.damped / now.external, 1.0, 0.1) << rate;
    EXPECT_NEAR(now.residual() / now.external, 0.0, 0.02) << rate;
  }
}

// The step limit is that without damping: see damping.hpp.
TEST(Damping, LeavesTheStepLimitWhereItIs) {
  for (const double x : {0.0, 0.01, 0.3, 0.63, 2.0, 20.0}) {
    const Damping damping(x);
    const auto grows = [&](double omega) {
      double u = 1.0, v = 0.0, max = 0.0;
      for (int n = 0; n < 4000; ++n) {
        v = damping.keep * v - damping.yield * omega * omega * u;
        u += v;
        max = std::max(max, std::abs(u));
      }
      return std::abs(u) > 1e3 || !std::isfinite(u);
    };
    EXPECT_FALSE(grows(2.0 * 0.98)) << x;
    const double limit = x > 0.0 ? std::sqrt(2.0 * x / std::tanh(0.5 * x)) : 2.0;
    EXPECT_GE(limit, 2.0);
    EXPECT_FALSE(grows(0.98 * limit)) << x;
    EXPECT_TRUE(grows(1.02 * limit)) << x;
  }
}

// A strongly damped plate under a small load at the default step, and rates that change on the way.
TEST(Damping, OfAnyRateIsStable) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.supports.push_back(
      support(strip(plate, Edge::bottom, 1e-3), Support::Kind::displacement, {0.0, 0.0}));
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e3}});
  plate.loads.damping = 3e6;
  Simulation simulation(plate, test::numerics());
  for (const double rate : {3e6, 2.2e6, 2.4e6, 1e7, 1e9, 0.0}) {
    Loads loads = simulation.plate().loads;
    loads.damping = rate;
    simulation.set_loads(loads);
    simulation.run(20e-6);
    EXPECT_EQ(count_damage(simulation).broken_bonds, 0) << rate;
    const Energy now = energy(simulation);
    EXPECT_LT(now.kinetic + now.strain, 1.01 * now.external) << rate;
  }
}

// Whenever it is said, it takes what there is and no more.
TEST(Damping, SaidLaterTakesWhatThereIs) {
  for (const double rate : {1e6, 5e6, 1e7, 1e8, 1e300}) {
    Plate plate = test::bare_plate(20, 10);
    plate.initial_conditions.push_back({std::nullopt, {0.0, 0.0}, {1.0, 0.0}});
    Simulation simulation(plate, test::numerics(), {1});
    const double there = simulation.kinetic_energy();
    simulation.run(5e-6);
    Loads loads = plate.loads;
    loads.damping = rate;
    simulation.set_loads(loads);
    EXPECT_NEAR(simulation.kinetic_energy() + simulation.ledger().damped, there, 1e-9 * there);
    simulation.run(40e-6);
    EXPECT_NEAR(simulation.ledger().damped, there, 1e-9 * there) << rate;
    EXPECT_LT(simulation.kinetic_energy(), 1e-9 * there) << rate;
    loads.damping = 0.0;
    simulation.set_loads(loads);
    simulation.run(1e-6);
    EXPECT_NEAR(simulation.ledger().damped, there, 1e-9 * there) << rate;
  }
}

}  // namespace
}  // namespace hackle
