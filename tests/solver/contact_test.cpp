// SPDX-License-Identifier: MIT
// Contact of crack faces and fragments, against a loop over all pairs of nodes, its own energy, and
// what a plate keeps: momentum, energy, mirror images, and its bits.
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "solver/contact_forces.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// Two halves without a bond between them, which never break, each with its own velocity.
Plate halves(const Vec2& left, const Vec2& right) {
  Plate plate = test::bare_plate(40, 20);
  plate.cracks.push_back({{0.01, 0.0}, {0.01, 0.01}});
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.02, 0.01}));
  plate.contact = Contact{};
  plate.starts.push_back({rectangle({0.0, 0.0}, {0.01, 0.01}), {{0, 0}}, {left}});
  plate.starts.push_back({rectangle({0.01, 0.0}, {0.02, 0.01}), {{0, 0}}, {right}});
  return plate;
}

// Fragments that fly about: a plate under a load that shatters it.
Plate shattering() {
  Plate plate = test::bare_plate(60, 40);
  plate.contact = Contact{};
  plate.scatter = Scatter{Scatter::Kind::weibull, 8.0, 1e-3, 5};
  plate.loads.impactors.push_back({{-5.1e-3, 0.01}, 5e-3, {150.0, 10.0}, 0.6});
  return plate;
}

struct AllPairs {
  std::vector<Vec2> acceleration;  // m/s2, by Grid::index
  double energy = 0.0;             // J/m
};

// The law as contact_forces.hpp states it, for every pair of nodes that lack a bond.
AllPairs all_pairs(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  const Contact contact = *simulation.plate().contact;
  const auto degree = degrees(grid, lattice.family, simulation.state().bonds);
  const double dx = grid.dx, delta = lattice.family.m() * dx, volume = dx * dx;
  AllPairs sum{std::vector<Vec2>(grid.nodes(), Vec2(0, 0)), 0.0};
  const auto node = [&](std::size_t n) {
    return std::pair(static_cast<int>(n) % grid.nx, static_cast<int>(n) / grid.nx);
  };
  for (std::size_t p = 0; p < grid.nodes(); ++p)
    for (std::size_t q = p + 1; q < grid.nodes(); ++q) {
      const auto [i, j] = node(p);
      const auto [k, l] = node(q);
      if (degree[p] == lattice.family.bonds() || degree[q] == lattice.family.bonds()) continue;
      const Vec2 apart =
          dx * Vec2(k - i, l - j) + (simulation.displacement(k, l) - simulation.displacement(i, j));
      const double rest = dx * std::hypot(k - i, l - j);
      const double d = contact.reach * std::min(rest, 1.5 * dx), r = apart.norm();
      if (r >= d || simulation.holds(i, j, k - i, l - j)) continue;
      const double density = contact.stiffness * lattice.calibration.c * (d - r) / delta;
      const Vec2 acceleration = (density * volume / lattice.rho / r) * apart;
      sum.acceleration[q] += acceleration;
      sum.acceleration[p] -= acceleration;
      sum.energy += 0.5 * density * (d - r) * volume * volume;
    }
  return sum;
}

void expect_agreement(const Simulation& simulation) {
  const AllPairs wanted = all_pairs(simulation);
  ContactForces contact(*simulation.plate().contact, simulation.lattice(), simulation.dt());
  contact.begin(simulation.lattice(), simulation.state());
  contact.update(simulation.lattice(), simulation.state());
  std::vector<Vec2> found(wanted.acceleration.size(), Vec2(0, 0));
  for (const LoadedNode& load : contact.forces())
    found[simulation.lattice().grid.index(load.i, load.j)] = load.acceleration;
  // Forces are rounded to 2^-44 lattice units, which are dx/dt^2.
  const double unit = simulation.lattice().grid.dx / (simulation.dt() * simulation.dt());
  for (std::size_t n = 0; n < found.size(); ++n)
    ASSERT_LT((found[n] - wanted.acceleration[n]).norm(), 1e-11 * unit) << n;
  EXPECT_NEAR(simulation.contact_energy(), wanted.energy, 1e-8);  // J/m; 2^-44 units are 1e-10
}

TEST(ContactForces, AreThoseOfAllPairs) {
  for (const double reach : {0.8, 0.9, 1.0}) {
    Plate plate = halves({3.0, 1.0}, {-3.0, 0.5});
    plate.contact->reach = reach;
    Simulation simulation(plate, test::numerics(), {1});
    simulation.restore(test::jolted(simulation.state(), 0.3, 11));
    expect_agreement(simulation);
    EXPECT_GT(simulation.contact_energy(), 0.0);
  }
}

// Whatever has broken and wherever it has flown since the pairs were first sought.
TEST(ContactForces, FollowFragments) {
  Simulation simulation(shattering(), test::numerics(), {1});
  int touched = 0;
  for (int k = 0; k < 12; ++k) {
    simulation.run(5e-6);
    expect_agreement(simulation);
    touched += simulation.contact_energy() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(touched, 6);
}

TEST(ContactForces, AddUpToNothing) {
  Simulation simulation(halves({3.0, 1.0}, {-3.0, 0.5}), test::numerics(), {1});
  simulation.restore(test::jolted(simulation.state(), 0.3, 3));
  Vec2 sum(0, 0);
  double most = 0.0;
  for (const LoadedNode& load : simulation.loading().forces()) {
    sum += load.acceleration;
    most = std::max(most, load.acceleration.norm());
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LT(sum.norm(), 1e-12 * most);
}

// The halves meet and part again: what is lost is what the step rounds off the springs of contact,
// which is second order in it.
TEST(Contact, KeepsEnergyAndMomentum) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(halves({20.0, 0.0}, {-20.0, 5.0}), numerics, {1});
    double stored = 0.0;
    for (int k = 0; k < 40; ++k) {
      simulation.run(0.5e-6);
      const Energy ledger = energy(simulation);
      stored = std::max(stored, ledger.contact);
      EXPECT_LT(std::abs(ledger.residual()), 0.01 * ledger.external) << simulation.time();
    }
    EXPECT_GT(stored, 0.05 * energy(simulation).external);
    EXPECT_EQ(simulation.contact_energy(), 0.0);  // they have parted
    Vec2 momentum(0, 0), speed(0, 0);
    for (const Vec2& v : simulation.velocities()) {
      momentum += v;
      speed += v.cwiseAbs();
    }
    EXPECT_NEAR(momentum.y(), 400 * 5.0, 1e-4);
    EXPECT_NEAR(momentum.x(), 0.0, 1e-6 * speed.x());
  }
}

TEST(Contact, LosesEnergyOfSecondOrderInTheStep) {
  const auto leak = [](double dt) {
    Numerics numerics = test::numerics();
    numerics.step = dt;
    Simulation simulation(halves({20.0, 0.0}, {-20.0, 5.0}), numerics, {1});
    double most = 0.0;
    for (int k = 0; k < 20; ++k) {
      simulation.run(0.48e-6);
      most = std::max(most, std::abs(energy(simulation).residual()));
    }
    return most;
  };
  EXPECT_GT(leak(120e-9) / leak(60e-9), 3.0);
}

TEST(Contact, StopsFacesThatWouldPassThroughEachOther) {
  const auto overlap = [](bool contact) {
    Plate plate = halves({20.0, 0.0}, {-20.0, 0.0});
    if (!contact) plate.contact.reset();
    Simulation simulation(plate, test::numerics(), {1});
    double most = 0.0;
    for (int k = 0; k < 40; ++k) {
      simulation.run(0.5e-6);
      most =
          std::max(most, simulation.displacement(19, 10).x() - simulation.displacement(20, 10).x());
    }
    return most / simulation.lattice().grid.dx;
  };
  EXPECT_GT(overlap(false), 1.5);
  EXPECT_LT(overlap(true), 0.6);
}

TEST(Contact, KeepsMirrorImages) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = halves({20.0, 0.0}, {-20.0, 0.0});
    plate.no_fail.clear();
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {2});
    simulation.run(15e-6);
    EXPECT_GT(count_damage(simulation).broken_bonds, 0);
    EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
    EXPECT_EQ(test::asymmetric_nodes(simulation, false), 0);
  }
}

TEST(Contact, BitsDoNotDependOnThreadsOrPieces) {
  const auto hash = [](int threads, int pieces) {
    Simulation simulation(shattering(), test::numerics(), {threads});
    for (int k = 0; k < pieces; ++k) simulation.run(40e-6 / pieces);
    return simulation.state().hash();
  };
  const std::string whole = hash(1, 1);
  EXPECT_EQ(hash(3, 1), whole);
  EXPECT_EQ(hash(2, 7), whole);
}

TEST(Contact, GoesOnFromAKeptState) {
  Simulation simulation(shattering(), test::numerics(), {1});
  simulation.run(20e-6);
  const State kept = simulation.state();
  simulation.run(20e-6);
  Simulation other(shattering(), test::numerics(), {1});
  other.restore(kept);
  other.run(40e-6 - other.time());
  EXPECT_EQ(other.state().hash(), simulation.state().hash());
}

// The limit of the step counts with contacts: at it, no contact gains energy.
TEST(Contact, IsStableAtTheLimitOfTheStep) {
  for (const double stiffness : {15.0, 100.0}) {
    Plate plate = halves({20.0, 5.0}, {-20.0, 0.0});
    plate.contact->stiffness = stiffness;
    Numerics numerics = test::numerics();
    numerics.step = Lattice(plate, numerics).step_limit;
    Simulation simulation(plate, numerics, {1});
    for (int k = 0; k < 30; ++k) {
      simulation.run(1e-6);
      const Energy ledger = energy(simulation);
      EXPECT_LT(std::abs(ledger.residual()), 0.03 * ledger.external);
    }
    plate.contact.reset();
    EXPECT_LT(*numerics.step, Lattice(plate, test::numerics()).step_limit);
  }
}

}  // namespace
}  // namespace hackle
