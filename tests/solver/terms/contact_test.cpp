// SPDX-License-Identifier: MIT
// Contact of crack faces and fragments, against a loop over all pairs of nodes, its own energy, and
// what a plate keeps: momentum, energy, mirror images, and its bits.
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "solver/cpu/engine.hpp"
#include "solver/terms/contact_forces.hpp"
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
  plate.initial_conditions.push_back({rectangle({0.0, 0.0}, {0.01, 0.01}), {{0, 0}}, {left}});
  plate.initial_conditions.push_back({rectangle({0.01, 0.0}, {0.02, 0.01}), {{0, 0}}, {right}});
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

// A bond that a node lost, seen from there, on a plate without cut-outs and at rest temperature.
struct Lost {
  std::size_t other = 0;  // Grid::index
  Vec2 apart{0, 0};
  double length = 0.0, s = 0.0, c = 0.0;  // of the bond; c of both its ends, times its weight
};

std::vector<Lost> lost_bonds(const Simulation& simulation, int i, int j) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  std::vector<Lost> lost;
  const auto look = [&](int a, int b, const Vec2& xi, double weight) {
    const Vec2 apart =
        grid.dx * xi + simulation.displacement(i + a, j + b) - simulation.displacement(i, j);
    const double length = grid.dx * xi.norm();
    const double c = lattice.micromodulus_at(i, j) + lattice.micromodulus_at(i + a, j + b);
    lost.push_back(
        {grid.index(i + a, j + b), apart, length, apart.norm() / length - 1.0, 0.5 * weight * c});
  };
  const BondBits& bonds = simulation.state().bonds;
  lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    if (grid.contains(i + a, j + b) && !bonds.holds(grid.layout().at(i, j), bit))
      look(a, b, xi, weight);
    if (grid.contains(i - a, j - b) && !bonds.holds(grid.layout().at(i - a, j - b), bit))
      look(-a, -b, -xi, weight);
  });
  return lost;
}

// The law as crack_faces.hpp states it, node by node.
void add_faces(const Simulation& simulation, AllPairs& sum) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  const double volume = grid.dx * grid.dx, k = 1.2;
  const auto rho = [&](std::size_t node) {
    const auto columns = static_cast<std::size_t>(grid.nx);
    return lattice.material_at(static_cast<int>(node % columns), static_cast<int>(node / columns))
        .material.rho;
  };
  const auto faded = [](double s) { return s > 0.0 ? std::max(1.0 - s / 4.0, 0.0) : 1.0; };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      double nearer = 0.0, stiffness = 0.0;
      const std::vector<Lost> lost = lost_bonds(simulation, i, j);
      for (const Lost& bond : lost) {
        nearer += bond.c * bond.length * bond.s * std::pow(faded(bond.s), 2);
        stiffness += bond.c * bond.length;
      }
      if (!(nearer < 0.0)) continue;
      const double eps = nearer / stiffness;
      sum.energy += 0.25 * k * stiffness * eps * eps * volume * volume;
      for (const Lost& bond : lost) {
        const double slope = bond.s > 0.0 ? faded(bond.s) * (1.0 - 3.0 * bond.s / 4.0) : 1.0;
        const Vec2 force =
            (0.5 * k * bond.c * eps * slope * volume / bond.apart.norm()) * bond.apart;
        const std::size_t node = grid.index(i, j);
        sum.acceleration[node] += force / rho(node);
        sum.acceleration[bond.other] -= force / rho(bond.other);
      }
    }
}

// The laws as contact_forces.hpp and crack_faces.hpp state them, for every pair of nodes that lack
// a bond.
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
  for (std::size_t p = 0; p < grid.nodes(); ++p) {
    if (degree[p] == lattice.family.bonds()) continue;
    for (std::size_t q = p + 1; q < grid.nodes(); ++q) {
      if (degree[q] == lattice.family.bonds()) continue;
      const auto [i, j] = node(p);
      const auto [k, l] = node(q);
      const Vec2 apart =
          dx * Vec2(k - i, l - j) + (simulation.displacement(k, l) - simulation.displacement(i, j));
      const double rest = dx * std::hypot(k - i, l - j);
      const double d = contact.reach * std::min(rest, 1.5 * dx), r = apart.norm();
      if (r >= d || simulation.holds(i, j, k - i, l - j)) continue;
      const double c = 0.5 * (lattice.micromodulus_at(i, j) + lattice.micromodulus_at(k, l));
      const double density = contact.stiffness * c * (d - r) / delta;
      const Vec2 force = (density * volume / r) * apart;
      sum.acceleration[q] += force / lattice.material_at(k, l).material.rho;
      sum.acceleration[p] -= force / lattice.material_at(i, j).material.rho;
      sum.energy += 0.5 * density * (d - r) * volume * volume;
    }
  }
  add_faces(simulation, sum);
  return sum;
}

void expect_forces(std::span<const LoadedNode> found, const AllPairs& wanted,
                   const Simulation& simulation) {
  std::vector<Vec2> sum(wanted.acceleration.size(), Vec2(0, 0));
  for (const LoadedNode& load : found)
    sum[simulation.lattice().grid.index(load.i, load.j)] = load.acceleration;
  // Forces are rounded to 2^-44 lattice units, which are dx/dt^2.
  const double unit = simulation.lattice().grid.dx / (simulation.dt() * simulation.dt());
  for (std::size_t n = 0; n < sum.size(); ++n)
    ASSERT_LT((sum[n] - wanted.acceleration[n]).norm(), 1e-11 * unit)
        << n << " at " << simulation.time();
}

void expect_agreement(const Simulation& simulation) {
  const AllPairs wanted = all_pairs(simulation);
  ContactForces contact(*simulation.plate().contact, simulation.lattice(), simulation.dt());
  State state = simulation.state();
  const Threads threads(1);
  const std::unique_ptr<Stepper> stepper =
      make_engine(state.precision(), simulation.lattice(), {.dt = simulation.dt()}, threads);
  const std::vector<double> cold;
  const Surroundings around{
      simulation.lattice(), simulation.dt(), threads, *stepper, {}, cold, undivided};
  contact.begin(around, state);
  contact.update(around, state);
  expect_forces(contact.forces(), wanted, simulation);
  const double stored = contact.stored() * simulation.lattice().rho *
                        std::pow(simulation.lattice().grid.dx, 4) /
                        (simulation.dt() * simulation.dt());
  EXPECT_NEAR(stored, wanted.energy, 1e-8);  // J/m; 2^-44 units are 1e-10
}

TEST(ContactForces, AreThoseOfAllPairs) {
  for (const double reach : {0.8, 0.9, 1.0}) {
    Plate plate = halves({3.0, 1.0}, {-3.0, 0.5});
    plate.contact->reach = reach;
    Simulation simulation(plate, test::numerics(), {1});
    simulation.restore(test::jolted(simulation.state(), 0.3, 11));
    expect_agreement(simulation);
    EXPECT_GT(simulation.ledger().contact, 0.0);
  }
}

// Whatever has broken and wherever it has flown since the pairs were first sought.
TEST(ContactForces, FollowFragments) {
  Simulation simulation(shattering(), test::numerics(), {1});
  int touched = 0;
  for (int k = 0; k < 6; ++k) {
    simulation.run(10e-6);
    expect_agreement(simulation);
    touched += simulation.ledger().contact > 0.0 ? 1 : 0;
  }
  EXPECT_GT(touched, 3);
}

// A plate of two materials that is torn along a strip in its middle by velocities, and whose halves
// come back: what acts in the run is what loops over all pairs say, through every break.
TEST(ContactForces, AreThoseOfACrackThatOpensInTheRunAndClosesAgain) {
  Plate plate = test::bare_plate(24, 20);
  Material resin = plate.material;
  resin.E = 4e9;
  resin.rho = 1200.0;
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {0.006, 0.005}), resin});
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.005, 0.01}));
  plate.no_fail.push_back(rectangle({0.007, 0.0}, {0.012, 0.01}));
  plate.contact = Contact{};
  plate.initial_conditions = {{rectangle({0.0, 0.0}, {0.006, 0.01}), {{0, 0}}, {Vec2(-40.0, 0)}},
                              {rectangle({0.006, 0.0}, {0.012, 0.01}), {{0, 0}}, {Vec2(40.0, 0)}}};
  Simulation simulation(plate, test::numerics(), {1});
  const auto agrees = [&] {
    simulation.run(0.5e-6);
    expect_forces(simulation.actions().forces, all_pairs(simulation), simulation);
  };
  for (int k = 0; k < 12; ++k) agrees();
  EXPECT_GT(count_damage(simulation).broken_bonds, 100);
  simulation.restore(test::reversed(simulation));
  double stored = 0.0;
  for (int k = 0; k < 24; ++k) {
    agrees();
    stored = std::max(stored, simulation.ledger().contact);
  }
  EXPECT_GT(stored, 0.0);
}

TEST(ContactForces, AddUpToNothing) {
  Simulation simulation(halves({3.0, 1.0}, {-3.0, 0.5}), test::numerics(), {1});
  simulation.restore(test::jolted(simulation.state(), 0.3, 3));
  Vec2 sum(0, 0);
  double max = 0.0;
  for (const LoadedNode& load : simulation.actions().forces) {
    sum += load.acceleration;
    max = std::max(max, load.acceleration.norm());
  }
  EXPECT_GT(max, 0.0);
  EXPECT_LT(sum.norm(), 1e-12 * max);
}

// The largest residual of the ledger as the halves meet and part again, over what was put in.
double largest_residual(Simulation& simulation) {
  double max = 0.0;
  for (int k = 0; k < 40; ++k) {
    simulation.run(0.5e-6);
    const Energy ledger = energy(simulation);
    max = std::max(max, std::abs(ledger.residual()) / ledger.external);
  }
  return max;
}

// What is lost is what the step rounds off the springs of contact, which is second order in it; the
// shock does as much in a plate that is whole.
TEST(Contact, KeepsEnergyAndMomentum) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(halves({20.0, 0.0}, {-20.0, 5.0}), numerics, {1});
    Plate whole = halves({20.0, 0.0}, {-20.0, 5.0});
    whole.cracks.clear();
    Simulation without(whole, numerics, {1});
    EXPECT_LT(largest_residual(simulation), 1.5 * largest_residual(without));
    EXPECT_EQ(simulation.ledger().contact, 0.0);  // they have parted
    Vec2 momentum(0, 0), speed(0, 0);
    for (const Vec2& v : simulation.velocities()) {
      momentum += v;
      speed += v.cwiseAbs();
    }
    // Rounding of some hundred steps, which adds up as a random walk.
    const double rounding = precision == Precision::f32 ? 1.2e-7 : 2.2e-16;
    EXPECT_NEAR(momentum.y(), 400 * 5.0, 10.0 * rounding * speed.y());
    EXPECT_NEAR(momentum.x(), 0.0, 1e-6 * speed.x());
  }
}

TEST(Contact, LosesEnergyOfSecondOrderInTheStep) {
  const auto leak = [](double dt) {
    Numerics numerics = test::numerics();
    numerics.step = dt;
    Simulation simulation(halves({20.0, 0.0}, {-20.0, 5.0}), numerics, {1});
    double max = 0.0;
    for (int k = 0; k < 20; ++k) {
      simulation.run(0.48e-6);
      max = std::max(max, std::abs(energy(simulation).residual()));
    }
    return max;
  };
  EXPECT_GT(leak(120e-9) / leak(60e-9), 3.0);
}

TEST(Contact, StopsFacesThatWouldPassThroughEachOther) {
  const auto overlap = [](bool contact) {
    Plate plate = halves({20.0, 0.0}, {-20.0, 0.0});
    if (!contact) plate.contact.reset();
    Simulation simulation(plate, test::numerics(), {1});
    double max = 0.0;
    for (int k = 0; k < 40; ++k) {
      simulation.run(0.5e-6);
      max =
          std::max(max, simulation.displacement(19, 10).x() - simulation.displacement(20, 10).x());
    }
    return max / simulation.lattice().grid.dx;
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
