// SPDX-License-Identifier: MIT
// Rigid discs thrown at a plate: what they push, what they lose, and what is refused.
#include "solver/terms/impact.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr double radius = 4e-3, mass = 0.5;

// A disc beside the left edge of a plate that never breaks.
Plate hit(const Vec2& velocity, double y = 0.01) {
  Plate plate = test::bare_plate(60, 40);
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.03, 0.02}));
  plate.loads.impactors.push_back({{-radius, y}, radius, velocity, mass});
  return plate;
}

Vec2 velocity_of(const Simulation& simulation) {
  return simulation.state().discs.front().velocity *
         (simulation.lattice().grid.dx / simulation.dt());
}

// The law for every node.
std::vector<LoadedNode> reference(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const Grid& grid = lattice.grid;
  const Vec2 centre = grid.centre + grid.dx * simulation.state().discs.front().centre;
  std::vector<LoadedNode> pushed;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 node = grid.position(i, j) + simulation.displacement(i, j);
      const Vec2 half(0.5 * grid.dx, 0.5 * grid.dx);
      const Vec2 apart = centre.cwiseMax(node - half).cwiseMin(node + half) - centre;
      const double r = apart.norm();
      if (r >= radius) continue;
      const double density =
          15.0 * lattice.micromodulus_at(i, j) * (radius - r) / (lattice.family.m() * grid.dx);
      const double rho = lattice.material_at(i, j).material.rho;
      pushed.push_back({i, j, (density * grid.dx * grid.dx / rho / r) * apart, rho / lattice.rho});
    }
  return pushed;
}

// Another material at the lower left, where half of the nodes are that are hit.
Plate hit_half(double E, double rho, const Vec2& velocity) {
  Plate plate = hit(velocity);
  Material other = plate.material;
  other.E = E;
  other.rho = rho;
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {0.01, 0.01}), other});
  return plate;
}

struct Stuff {
  double E, rho;
};
constexpr Stuff stuffs[] = {{210e9, 7850.0}, {4e9, 1200.0}};

TEST(Impact, PushesWhatItCovers) {
  for (const Plate& plate : {hit({80.0, -10.0}), hit_half(210e9, 7850.0, {80.0, -10.0}),
                             hit_half(4e9, 1200.0, {80.0, -10.0})}) {
    Simulation simulation(plate, test::numerics(), {1});
    std::size_t max = 0;
    for (int k = 0; k < 60; ++k) {
      simulation.step();
      const auto wanted = reference(simulation);
      const auto& found = simulation.actions().forces;
      ASSERT_EQ(found.size(), wanted.size()) << k;
      for (std::size_t n = 0; n < found.size(); ++n) {
        EXPECT_EQ(found[n].i, wanted[n].i);
        EXPECT_EQ(found[n].j, wanted[n].j);
        EXPECT_EQ(found[n].inertia, wanted[n].inertia);
        EXPECT_LT((found[n].acceleration - wanted[n].acceleration).norm(),
                  1e-9 * wanted[n].acceleration.norm() + 1.0);
      }
      max = std::max(max, found.size());
    }
    EXPECT_GT(max, 5U);
  }
}

// Of steel and of resin, too. Momenta of plate and disc belong to the same moment, half a step ago.
TEST(Impact, KeepsMomentumAndItsLedgerOnEveryMaterial) {
  for (const Stuff& other : stuffs) {
    const Vec2 before(40.0, 10.0);
    Simulation simulation(hit_half(other.E, other.rho, before), test::numerics(), {1});
    simulation.run(20e-6);
    const Lattice& lattice = simulation.lattice();
    const Grid& grid = lattice.grid;
    Vec2 momentum(0, 0);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        momentum += lattice.material_at(i, j).material.rho * simulation.state().v(i, j);
    momentum *= grid.dx * grid.dx * (grid.dx / simulation.dt());
    const Vec2 given = mass * (before - velocity_of(simulation));
    EXPECT_GT(given.x(), 0.1 * mass * before.x());
    EXPECT_LT((momentum - given).norm(), 1e-7 * given.norm());
    const Energy ledger = energy(simulation);
    EXPECT_LT(std::abs(ledger.residual()), 0.01 * ledger.external);
  }
}

// The same disc at the left, right, lower and upper edge of a square, at heights of nodes and
// between them: it goes back as if the plate were turned.
TEST(Impact, IsTheSameFromEverySide) {
  for (const double off : {0.0, 0.25e-3, 1.1e-3}) {
    const auto goes_back = [&](const Vec2& side) {
      Plate plate = test::bare_plate(40, 40);
      plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.02, 0.02}));
      const Vec2 along(-side.y(), side.x()), middle(0.01, 0.01);
      plate.loads.impactors.push_back({middle + (0.01 + radius) * side + off * along, radius,
                                       Vec2(-60.0 * side + 7.0 * along), mass});
      Simulation simulation(plate, test::numerics(), {1});
      simulation.run(20e-6);
      const Vec2 velocity = velocity_of(simulation);
      return Vec2(velocity.dot(side), velocity.dot(along));
    };
    const Vec2 left = goes_back({-1, 0});
    EXPECT_GT(left.x(), -50.0);
    for (const Vec2& side : {Vec2(1, 0), Vec2(0, -1), Vec2(0, 1)})
      EXPECT_LT((goes_back(side) - left).norm(), 1e-8) << side.transpose();
  }
}

// The nearest point of the cells of a plate, in m from `centre`.
Vec2 nearest_of(const Simulation& simulation, const Vec2& centre) {
  const Lattice& lattice = simulation.lattice();
  const Vec2 half(0.5 * lattice.grid.dx, 0.5 * lattice.grid.dx);
  Vec2 nearest(1.0, 1.0);
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i) {
      if (lattice.is_void(i, j)) continue;
      const Vec2 node = lattice.grid.position(i, j);
      const Vec2 way = centre.cwiseMax(node - half).cwiseMin(node + half) - centre;
      if (way.norm() < nearest.norm()) nearest = way;
    }
  return nearest;
}

// Beside edges and corners, in a hole and in a notch: a disc that fits between the cells pushes in
// the first step, one that is a little larger is refused.
TEST(Impact, ADiscTouchesWhatIsDrawn) {
  for (const Vec2& centre :
       {Vec2(-3e-3, 0.01), Vec2(-3e-3, 0.0102), Vec2(0.033, 0.0137), Vec2(-2e-3, -3e-3),
        Vec2(0.017, 0.024), Vec2(0.0151, 0.0099), Vec2(0.0283, 0.006)}) {
    Plate plate = test::bare_plate(60, 40);
    plate.cutouts.push_back({Ellipse{{0.015, 0.01}, {4e-3, 3e-3}}, ""});
    plate.cutouts.push_back({rectangle({0.026, 0.004}, {0.031, 0.008}), ""});
    const Vec2 way = nearest_of(Simulation(plate, test::numerics(), {1}), centre);
    const auto with = [&](double r) {
      Plate thrown = plate;
      thrown.loads.impactors.push_back({centre, r, Vec2(50.0 * way.normalized()), mass});
      return Simulation(thrown, test::numerics(), {1});
    };
    Simulation simulation = with((1.0 - 1e-12) * way.norm());
    EXPECT_TRUE(simulation.actions().forces.empty());
    simulation.step();
    EXPECT_FALSE(simulation.actions().forces.empty()) << centre.transpose();
    EXPECT_THROW(with(way.norm() + 1e-3 * 0.5e-3), Error) << centre.transpose();
  }
}

TEST(Impact, TheOrderOfDiscsMeansNothing) {
  const Impactor one{{-radius, 0.008}, radius, {40.0, 5.0}, mass};
  const Impactor two{{-radius, 0.012}, radius, {60.0, -5.0}, 2.0 * mass};
  const auto moved = [](const Impactor& first, const Impactor& second) {
    Plate plate = hit({40.0, 0.0});
    plate.loads.impactors = {first, second};
    Simulation simulation(plate, test::numerics(), {1});
    simulation.run(15e-6);
    State state = simulation.state();
    state.discs.clear();
    return state.hash();
  };
  EXPECT_EQ(moved(one, two), moved(two, one));
}

TEST(Impact, GivesThePlateWhatTheDiscLoses) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    const Vec2 before(40.0, 10.0);
    Simulation simulation(hit(before), numerics, {1});
    simulation.run(80e-6);
    const Vec2 after = velocity_of(simulation);
    ASSERT_TRUE(simulation.actions().forces.empty());  // they have parted
    EXPECT_LT(after.x(), 0.9 * before.x());
    const double lost = 0.5 * mass * (before.squaredNorm() - after.squaredNorm());
    EXPECT_NEAR(simulation.ledger().external, lost, 5e-3 * lost);
    const Energy ledger = energy(simulation);
    EXPECT_LT(std::abs(ledger.residual()), 5e-3 * ledger.external);
    Vec2 momentum(0, 0);
    for (const Vec2& v : simulation.velocities()) momentum += v;
    momentum *= 2235.0 * 0.25e-6;
    EXPECT_LT((momentum - mass * (before - after)).norm(), 1e-5 * mass * before.norm());
  }
}

TEST(Impact, ADiscThatMissesFliesOnAndCostsNothing) {
  Plate plate = hit({80.0, 0.0}, 0.0251);
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(50e-6);
  EXPECT_LT((velocity_of(simulation) - Vec2(80.0, 0.0)).norm(), 1e-13 * 80.0);
  EXPECT_EQ(simulation.ledger().external, 0.0);
  EXPECT_EQ(simulation.displacement(0, 39), Vec2(0, 0));
  const Vec2 centre = simulation.state().discs.front().centre * 0.5e-3;
  EXPECT_NEAR(centre.x(), -radius - 0.015 + 80.0 * simulation.time(), 1e-9);
}

TEST(Impact, KeepsMirrorImages) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = hit({80.0, 0.0});
    plate.no_fail.clear();
    plate.contact = Contact{};
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {2});
    simulation.run(40e-6);
    EXPECT_GT(count_damage(simulation).broken_bonds, 100);
    EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
    EXPECT_EQ(velocity_of(simulation).y(), 0.0);
  }
}

TEST(Impact, BitsDoNotDependOnThreadsOrPieces) {
  const auto hash = [](int threads, int pieces) {
    Simulation simulation(hit({80.0, 30.0}), test::numerics(), {threads});
    for (int k = 0; k < pieces; ++k) simulation.run(40e-6 / pieces);
    return simulation.state().hash();
  };
  const std::string whole = hash(1, 1);
  EXPECT_EQ(hash(3, 1), whole);
  EXPECT_EQ(hash(2, 9), whole);
}

TEST(Impact, TwoDiscsThatCoverANodePushItTogether) {
  Plate plate = hit({40.0, 0.0});
  plate.loads.impactors.push_back({{-radius, 0.01}, radius, {40.0, 0.0}, mass});
  Numerics numerics = test::numerics();
  numerics.step = 150e-9;
  Simulation twice(plate, numerics, {1}), once(hit({40.0, 0.0}), numerics, {1});
  while (once.actions().forces.empty()) {
    once.step();
    twice.step();
  }
  const auto &one = once.actions().forces, &two = twice.actions().forces;
  ASSERT_EQ(two.size(), one.size());
  for (std::size_t n = 0; n < one.size(); ++n)
    EXPECT_EQ(two[n].acceleration, Vec2(2.0 * one[n].acceleration));
}

TEST(Impact, ADiscMayComeLater) {
  Simulation simulation(hit({40.0, 0.0}), test::numerics(), {1});
  simulation.run(20e-6);
  const Disc first = simulation.state().discs.front();
  Loads loads = simulation.plate().loads;
  loads.impactors.push_back({{0.035, 0.01}, radius, {-40.0, 0.0}, mass});
  simulation.set_loads(loads);
  ASSERT_EQ(simulation.state().discs.size(), 2U);
  EXPECT_EQ(simulation.state().discs.front().centre, first.centre);
  simulation.run(20e-6);
  EXPECT_GT(simulation.state().discs.back().velocity.x(), -40.0 * simulation.dt() / 0.5e-3);
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

// A fast disc sets the step; where the step is given it is checked, before the run and in it.
TEST(Impact, ADiscCrossesNoMoreThanATenthOfASpacingInAStep) {
  for (const double speed : {100.0, 1e3, 1e4, 3e4}) {
    Simulation simulation(hit({speed, 0.0}), test::numerics(), {1});
    EXPECT_LE(speed * simulation.dt(), 0.1 * 0.5e-3) << speed;
    EXPECT_LT(simulation.dt(), simulation.lattice().step_limit);
  }
  Numerics numerics = test::numerics();
  numerics.step = 60e-9;
  EXPECT_EQ(refusal([&] { Simulation(hit({800.0, 0.0}), numerics, {1}); }), "");
  EXPECT_THAT(refusal([&] {
                Simulation(hit({0.0, -1e3}), numerics, {1});
              }),
              testing::AllOf(testing::HasSubstr("in a step of 60 ns it crosses 0.12 spacings"),
                             testing::HasSubstr("a step of 50 ns or less")));
  Plate plate = hit({800.0, 0.0});
  plate.loads.impactors.clear();
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(1e-6);
  const std::string before = simulation.state().hash();
  EXPECT_THAT(refusal([&] {
                simulation.set_loads(hit({800.0, 0.0}).loads);
              }),
              testing::AllOf(testing::HasSubstr("crosses 0.32 spacings"),
                             testing::HasSubstr("a step of 62.5 ns or less")));
  EXPECT_EQ(simulation.state().hash(), before);
  EXPECT_EQ(refusal([&] { simulation.set_loads(hit({200.0, 0.0}).loads); }), "");
}

// At the largest step that is taken, a disc that is pressed far into a plate that cannot break
// gives and takes energy, but makes none.
TEST(Impact, IsStableAtTheLimit) {
  for (const double m : {3.0, 4.0}) {
    Plate plate = hit({60.0, 0.0});
    Numerics numerics = test::numerics(0.5e-3, m * 0.5e-3);
    numerics.step = 0.98 * Lattice(plate, numerics).step_limit;
    Simulation simulation(plate, numerics, {1});
    simulation.run(200e-6);
    const Energy now = energy(simulation);
    EXPECT_LT(now.kinetic + now.strain, 1.05 * now.external) << m;
    EXPECT_GT(now.external, 0.0);
  }
}

struct BadDisc {
  Impactor impactor;
  const char* says;
};

class BadDiscs : public testing::TestWithParam<BadDisc> {};

TEST_P(BadDiscs, AreRefusedBeforeTheRunAndInIt) {
  Plate plate = test::bare_plate(60, 40);
  Simulation simulation(plate, test::numerics(), {1});
  const std::string before = simulation.state().hash();
  plate.loads.impactors.push_back(GetParam().impactor);
  EXPECT_THAT(refusal([&] { Simulation(plate, test::numerics(), {1}); }),
              testing::HasSubstr(GetParam().says));
  EXPECT_THAT(refusal([&] { simulation.set_loads(plate.loads); }),
              testing::HasSubstr(GetParam().says));
  EXPECT_EQ(simulation.state().hash(), before);
  EXPECT_TRUE(simulation.plate().loads.impactors.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, BadDiscs,
    testing::Values(BadDisc{{{0.0, 0.01}, radius, {1, 0}, mass}, "it overlaps the plate"},
                    BadDisc{{{-radius, 0.01}, 1e-4, {1, 0}, mass}, "under one spacing"},
                    BadDisc{{{-radius, 0.01}, radius, {1, 0}, 1e-3}, "less than that of the nodes"},
                    BadDisc{{{-radius, 0.01}, -1.0, {1, 0}, mass}, "radius is -1 m"},
                    BadDisc{{{-radius, NAN}, radius, {1, 0}, mass}, "centre is"},
                    BadDisc{{{-radius, 0.01}, radius, {INFINITY, 0}, mass}, "velocity is"}));

TEST(Impact, TheOrderOfDiscsIsNotInTheHash) {
  const auto hash = [](bool swapped) {
    Plate plate = test::bare_plate(40, 20);
    plate.loads.impactors = {{{-6e-3, 0.005}, 2e-3, {30.0, 0.0}, 0.2},
                             {{0.026, 0.006}, 3e-3, {-20.0, 1.0}, 0.3}};
    if (swapped) std::swap(plate.loads.impactors[0], plate.loads.impactors[1]);
    return Simulation(plate, test::numerics(), {1}).state().hash();
  };
  EXPECT_EQ(hash(true), hash(false));
}

}  // namespace
}  // namespace hackle
